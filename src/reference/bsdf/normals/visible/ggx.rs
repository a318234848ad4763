//! Visible normals of GGX; twin of `shaders/bsdf/normals/visible/ggx.glsl`.

use crate::reference::bsdf::distribution::ggx::{ggx_d, ggx_g1};
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::math::{Real, Vec3, dot3, max2, normalize3, vec3};

/// A visible micro-normal (Dupuy & Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023).
///
/// w = normalize(α wo.x, α wo.y, wo.z); a point of the cap z ∈ (−w.z, 1] about N, and h = this point + w. In z = (1 −
/// u2)(1 + w.z) − w.z both h.z and 1 ± z would cancel; computed separately they do not.
pub fn visible_ggx_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    let one = F::one();
    let alpha = at.material.width;
    let w = normalize3(vec3(alpha * at.wo.x, alpha * at.wo.y, at.wo.z));
    let (sin_phi, cos_phi) = F::sincos_2pi(u[0]);
    let height = one + w.z;
    // h.z = z + w.z
    let h_z = (one - u[1]) * height;
    // 1 − z, and 1 + z = h.z + (1 − w.z), 1 − w.z = (w.x² + w.y²)/(1 + w.z)
    let below_top = u[1] * height;
    let above_bottom = h_z + (w.x * w.x + w.y * w.y) / height;
    let radius = (below_top * above_bottom).sqrt();
    let h_x = radius * cos_phi + w.x;
    let h_y = radius * sin_phi + w.y;
    normalize3(vec3(alpha * h_x, alpha * h_y, h_z))
}

/// D_wo(m) = G1(wo) max(0, wo·m) D(m)/wo.z (Heitz 2018, eq. 3).
pub fn visible_ggx_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    let alpha = at.material.width;
    let c = max2(dot3(at.wo, m), F::zero());
    ggx_g1(at.wo, alpha) * c * ggx_d(m, alpha) / at.wo.z
}

//! Visible normals of Beckmann; twin of `shaders/bsdf/normals/visible/beckmann.glsl`.

use super::incidence::{above_zero, incidence, incidence_to_frame};
use super::slope::{SlopeLaw, slope_law, slope_sample, slope_share};
use crate::reference::bsdf::distribution::beckmann::beckmann_d;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::math::{Real, Vec3, dot3, max2, normalize3, vec3};

/// The distribution of facets seen along the plane of incidence.
#[derive(Clone, Copy, Debug)]
pub struct BeckmannView<F> {
    /// |(α wo.x, α wo.y, wo.z)|
    pub length: F,
    pub law: SlopeLaw<F>,
}

/// Slopes in units of α: wo·m = length (p + q t) mz, (p, q) = (wo.z, α sin θ)/length, and a Gaussian of them.
pub fn beckmann_view<F: Real>(wo: Vec3<F>, sine: F, alpha: F) -> BeckmannView<F> {
    let up = wo.z.abs();
    let along = alpha * sine;
    let length = (up * up + along * along).sqrt();
    let (p, q) = (up / length, along / length);
    // r = q/√π
    let r = q * F::new(0.564_189_583_547_756_3);
    BeckmannView {
        length,
        law: slope_law(p, r, F::zero(), up / along),
    }
}

/// A visible micro-normal: the slope along the plane of incidence Gaussian times visibility, the one across it Gaussian
/// (Heitz & d'Eon 2014; Jakob 2014).
pub fn visible_beckmann_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    let alpha = at.material.width;
    let plane = incidence(at.wo);
    let view = beckmann_view(at.wo, plane.sine, alpha);
    let along = alpha * slope_sample(view.law, u[0]);
    let across = alpha * F::erfc_inverse(F::new(2.0) * above_zero(u[1]));
    normalize3(incidence_to_frame(plane, vec3(along, across, F::one())))
}

/// D_wo(m) = G1(wo) max(0, wo·m) D(m)/wo.z with Smith's own G1 = 2 p/G(−p/q) (Walter et al. 2007, eq. 26's original,
/// 2/(1 + erf a + e^(−a²)/(a√π)), a = p/q), not the rational one.
pub fn visible_beckmann_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    let alpha = at.material.width;
    let view = beckmann_view(at.wo, incidence(at.wo).sine, alpha);
    let whole = slope_share(view.law, -view.law.limit).share;
    let c = max2(dot3(at.wo, m), F::zero());
    F::new(2.0) * c * beckmann_d(m, alpha) / (view.length * whole)
}

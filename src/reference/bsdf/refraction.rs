//! The refracted direction; twin of `shaders/bsdf/refraction.glsl`. Equation numbers are those of Walter et al. 2007.

use super::interaction::Interaction;
use super::snell::snell_radicand;
use crate::reference::math::{Real, Vec3, max2, normalize3, vec3};

/// √r = |wi·m| of the direction refracted at cosine `c` = wo·m; 0 at total reflection.
pub fn refracted_cosine<F: Real>(at: &Interaction<F>, c: F) -> F {
    max2(snell_radicand(at, c), F::zero()).sqrt()
}

/// wi·m + eta c = eta c − √r, without cancellation: −(1 − eta²)/(eta c + √r).
pub fn bend<F: Real>(at: &Interaction<F>, c: F) -> F {
    -at.one_minus_eta2 / (at.eta * c + refracted_cosine(at, c))
}

/// wi = (eta c − √r)m − eta wo (eq. 40), normalized; `c` = wo·m and r > 0.
pub fn refract_about<F: Real>(at: &Interaction<F>, m: Vec3<F>, c: F) -> Vec3<F> {
    normalize3(m * bend(at, c) - at.wo * at.eta)
}

/// The same about N' itself, whose cosine is wo.z: wi.z = −√r.
pub fn refract_about_normal<F: Real>(at: &Interaction<F>) -> Vec3<F> {
    let (x, y) = (at.eta * at.wo.x, at.eta * at.wo.y);
    normalize3(vec3(-x, -y, -refracted_cosine(at, at.wo.z)))
}

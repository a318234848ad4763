//! Fresnel's equations for a dielectric and unpolarised light; twin of `shaders/bsdf/fresnel/exact.glsl`.

use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::snell::snell_radicand;
use crate::reference::math::{Real, Vec3, max2, min2};

/// Walter et al. 2007, eq. 22, with g = √(c² + d) = √r/eta, d = (n_i/n_o)² − 1:
/// F = ½ A² (1 + B²), A = (g − c)/(g + c) = d/(g + c)², B = (c(g + c) − 1)/(c(g − c) + 1), g − c = d/(g + c).
///
/// Relative error in f32 at n = 1 + 1e-6: 5e-7; of the form with g − c: 9e-2.
pub fn fresnel_exact<F: Real>(at: &Interaction<F>, c: F) -> Vec3<F> {
    let r = snell_radicand(at, c);
    let g = max2(r, F::zero()).sqrt() / at.eta;
    let sum = g + c;
    let a = at.d / (sum * sum);
    let b = (c * sum - F::one()) / (F::one() + c * at.d / sum);
    let f = min2(F::new(0.5) * a * a * (F::one() + b * b), F::one());
    Vec3::splat(if r <= F::zero() { F::one() } else { f })
}

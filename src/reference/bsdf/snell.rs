//! Snell's law about a micro-normal, and total reflection; twin of `shaders/bsdf/snell.glsl`.

use super::interaction::Interaction;
use crate::reference::math::{Real, Vec3};

/// r = 1 − eta² (1 − c²) = (wi·m)² of the refracted direction, c = wo·m; not positive: total reflection.
///
/// Fresnel, Schlick's cosine and refraction all use this one radicand, so that they agree next to the critical angle.
/// Written (1 − eta²) + (eta c)², the first term given from f64.
pub fn snell_radicand<F: Real>(at: &Interaction<F>, c: F) -> F {
    let p = at.eta * c;
    at.one_minus_eta2 + p * p
}

/// Whether light that meets a micro-normal at cosine `c` is totally reflected.
pub fn total_reflection<F: Real>(at: &Interaction<F>, c: F) -> bool {
    snell_radicand(at, c) <= F::zero()
}

/// The share of light that an interface reflects: F, or at total reflection, where F = 1, the A(t) that absorption by
/// `term` puts in the place of E_r.
pub fn reflected_share<F: Real>(at: &Interaction<F>, c: F, f: Vec3<F>) -> Vec3<F> {
    if total_reflection(at, c) {
        at.attenuation
    } else {
        f
    }
}

//! Schlick's approximation; twin of `shaders/bsdf/fresnel/schlick.glsl`.

use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::snell::snell_radicand;
use crate::reference::math::{Real, Vec3, max2};

/// F0 + (1 − F0)(1 − cos)⁵ (Schlick 1994), with the cosine on the rarer side: c itself, or √r of refraction
/// where wo is in the denser medium. So both directions through an interface see one F, and F = 1 from the
/// critical angle on. An opaque material has eta = 1, hence c.
pub fn fresnel_schlick<F: Real>(at: &Interaction<F>, c: F) -> Vec3<F> {
    let r = snell_radicand(at, c);
    let refracted = max2(r, F::zero()).sqrt();
    let cosine = if at.eta > F::one() { refracted } else { c };
    let x = max2(F::one() - cosine, F::zero());
    let x2 = x * x;
    let f0 = at.material.f0;
    let f = f0 + (Vec3::one() - f0) * (x2 * x2 * x);
    if r <= F::zero() { Vec3::one() } else { f }
}

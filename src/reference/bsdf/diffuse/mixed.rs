//! The diffuse lobe next to others; twin of `shaders/bsdf/diffuse/mixed.glsl`. A kernel whose scene has no such
//! material fills the slot `<diffuse>` with `shaders/bsdf/diffuse/absent.glsl`, which is this with Kd = 0.

use super::lambert::{cosine_lobe, lambert_lobe};
use crate::reference::bsdf::choice::diffuse_probability;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::sample::BsdfValue;
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// Whether the uniform number `u` chooses the diffuse lobe.
pub fn diffuse_chosen<F: Real>(settings: &Settings, at: &Interaction<F>, u: F) -> bool {
    u < diffuse_probability(settings, at)
}

/// A direction of the diffuse lobe.
pub fn diffuse_direction<F: Real>(u: [F; 2]) -> Vec3<F> {
    cosine_lobe(u)
}

/// Probability p_m of the lobes that have a micro-normal.
pub fn facet_probability<F: Real>(settings: &Settings, at: &Interaction<F>) -> F {
    F::one() - diffuse_probability(settings, at)
}

/// The diffuse lobe and `rest`, the lobes with a micro-normal: values add up, densities by the lobes' shares.
pub fn with_diffuse<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    rest: BsdfValue<F>,
) -> BsdfValue<F> {
    let p_d = diffuse_probability(settings, at);
    let diffuse = lambert_lobe(at, wi);
    BsdfValue {
        value: diffuse.value + rest.value,
        pdf: p_d * diffuse.pdf + (F::one() - p_d) * rest.pdf,
    }
}

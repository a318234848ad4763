//! Opaque: a rough reflection, and Kd; twin of `shaders/bsdf/kind/glossy.glsl`.

use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::reflection::reflection_half_vector;
use crate::reference::bsdf::rough::{rough_draw, rough_reflection_at, rough_reflection_sample};
use crate::reference::bsdf::sample::{BsdfRandom, BsdfSample, BsdfValue};
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// Kd with probability p_d, else wo mirrored about a micro-normal (model.md, "Sampling a direction").
pub fn glossy_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    rough_reflection_sample(settings, at, rough_draw(settings, at, random), random)
}

/// Kd/π + E_r on wo's side, by the half vector (model.md, "Density and value").
pub fn glossy_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    rough_reflection_at(settings, at, wi, reflection_half_vector(at.wo, wi))
}

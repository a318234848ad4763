//! Kd alone; twin of `shaders/bsdf/kind/diffuse.glsl`.

use crate::reference::bsdf::diffuse::lambert::{cosine_lobe, lambert_lobe};
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DIFFUSE, sample_or_none,
};
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// The cosine lobe; the weight is Kd.
pub fn diffuse_sample<F: Real>(
    _settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let wi = cosine_lobe(random.d);
    sample_or_none(true, wi, lambert_lobe(at, wi), LOBE_DIFFUSE)
}

/// Kd/π on wo's side.
pub fn diffuse_eval<F: Real>(
    _settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
) -> BsdfValue<F> {
    lambert_lobe(at, wi)
}

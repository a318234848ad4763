//! A rough interface that hardly refracts, α·|n − 1| < 1e-5; twin of `shaders/bsdf/kind/weak_dielectric.glsl`.
//!
//! The transmitted lobe is so narrow that f32 cannot resolve its density at a given direction. It is drawn like that of
//! any rough interface, but counts as a delta lobe: its weight needs no Jacobian, and it is not connected to lights.
//! Reflection is the rough one, with a density.

use crate::reference::bsdf::diffuse::mixed::facet_probability;
use crate::reference::bsdf::facet::facet;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::reflection::reflection_half_vector;
use crate::reference::bsdf::refraction::refract_about;
use crate::reference::bsdf::rough::{
    rough_draw, rough_reflection_at, rough_reflection_sample, rough_reflects,
};
use crate::reference::bsdf::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DELTA, LOBE_TRANSMISSION, sample_or_none,
};
use crate::reference::bsdf::scaling::transmission_scale;
use crate::reference::bsdf::transmission::transmitted;
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// Transmission through the micro-normal `m`: D G (1 − F) c/wo.z, × eta² for radiance, over pm (1 − R), each per solid angle of m.
pub fn weak_dielectric_transmission<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfSample<F> {
    let x = facet(settings, at, wi, m);
    let p_m = facet_probability(settings, at);
    let value = BsdfValue {
        value: transmitted(at, x) * transmission_scale(settings, at.eta),
        pdf: p_m * x.pm * (F::one() - x.p_reflect),
    };
    let valid = x.c > F::zero() && at.wo.z > F::zero() && wi.z < F::zero();
    sample_or_none(valid, wi, value, LOBE_TRANSMISSION | LOBE_DELTA)
}

/// Draws as [`rough_dielectric_sample`](super::rough_dielectric::rough_dielectric_sample) does, with refraction as a
/// delta lobe.
pub fn weak_dielectric_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let draw = rough_draw(settings, at, random);
    if draw.diffuse || rough_reflects(settings, at, draw, random) {
        rough_reflection_sample(settings, at, draw, random)
    } else {
        weak_dielectric_transmission(settings, at, refract_about(at, draw.m, draw.c), draw.m)
    }
}

/// Kd/π + E_r on wo's side; the refracted lobe has no density.
pub fn weak_dielectric_eval<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
) -> BsdfValue<F> {
    rough_reflection_at(settings, at, wi, reflection_half_vector(at.wo, wi))
}

//! A smooth interface between two media, and Kd on wo's side; twin of `shaders/bsdf/kind/smooth_dielectric.glsl`.

use crate::reference::bsdf::choice::reflect_probability;
use crate::reference::bsdf::diffuse::mixed::{
    diffuse_chosen, diffuse_direction, facet_probability, with_diffuse,
};
use crate::reference::bsdf::fresnel::fresnel;
use crate::reference::bsdf::interaction::{Interaction, carried_mean};
use crate::reference::bsdf::refraction::refract_about_normal;
use crate::reference::bsdf::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION,
    LOBE_TRANSMISSION, no_value, sample_or_none,
};
use crate::reference::bsdf::scaling::transmission_scale;
use crate::reference::bsdf::snell::reflected_share;
use crate::reference::math::{Real, Vec3, vec3};
use crate::settings::Settings;

/// The delta lobes: the micro-normal is N', F reflects, (1 − F) is refracted, × eta² for radiance, × A(t).
pub fn smooth_dielectric_delta<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let (zero, one) = (F::zero(), F::one());
    let c = at.wo.z;
    let f = fresnel(at, c);
    let p_m = facet_probability(settings, at);
    let p_r = reflect_probability(settings, at, c, carried_mean(at, f));
    let scale = transmission_scale(settings, at.eta);
    if random.reflect < p_r {
        let value = BsdfValue {
            value: reflected_share(at, c, f),
            pdf: p_m * p_r,
        };
        let wi = vec3(-at.wo.x, -at.wo.y, c);
        sample_or_none(c > zero, wi, value, LOBE_REFLECTION | LOBE_DELTA)
    } else {
        let value = BsdfValue {
            value: (Vec3::one() - f) * at.attenuation * scale,
            pdf: p_m * (one - p_r),
        };
        let wi = refract_about_normal(at);
        let valid = c > zero && wi.z < zero;
        sample_or_none(valid, wi, value, LOBE_TRANSMISSION | LOBE_DELTA)
    }
}

/// Kd with probability p_d, else one of the delta lobes.
pub fn smooth_dielectric_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    if diffuse_chosen(settings, at, random.lobe) {
        let wi = diffuse_direction(random.d);
        sample_or_none(
            true,
            wi,
            smooth_dielectric_eval(settings, at, wi),
            LOBE_DIFFUSE,
        )
    } else {
        smooth_dielectric_delta(settings, at, random)
    }
}

/// The smooth interface has no density: Kd alone.
pub fn smooth_dielectric_eval<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
) -> BsdfValue<F> {
    with_diffuse(settings, at, wi, no_value())
}

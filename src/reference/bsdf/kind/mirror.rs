//! Opaque: a perfect mirror, and Kd; twin of `shaders/bsdf/kind/mirror.glsl`.

use crate::reference::bsdf::diffuse::mixed::{
    diffuse_chosen, diffuse_direction, facet_probability, with_diffuse,
};
use crate::reference::bsdf::fresnel::fresnel;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION, no_value,
    sample_or_none,
};
use crate::reference::math::{Real, Vec3, vec3};
use crate::settings::Settings;

/// Kd with probability p_d; else the mirrored direction (−wo.x, −wo.y, wo.z), whose weight is F(wo.z)/(1 − p_d).
pub fn mirror_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let diffuse = diffuse_chosen(settings, at, random.lobe);
    let wi = if diffuse {
        diffuse_direction(random.d)
    } else {
        vec3(-at.wo.x, -at.wo.y, at.wo.z)
    };
    let value = if diffuse {
        mirror_eval(settings, at, wi)
    } else {
        BsdfValue {
            value: fresnel(at, at.wo.z),
            pdf: facet_probability(settings, at),
        }
    };
    let lobe = if diffuse {
        LOBE_DIFFUSE
    } else {
        LOBE_REFLECTION | LOBE_DELTA
    };
    sample_or_none(wi.z > F::zero(), wi, value, lobe)
}

/// The mirror has no density: Kd alone.
pub fn mirror_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    with_diffuse(settings, at, wi, no_value())
}

//! A rough interface between two media, and Kd on wo's side; twin of `shaders/bsdf/kind/rough_dielectric.glsl`.

use crate::reference::bsdf::diffuse::mixed::{diffuse_direction, with_diffuse};
use crate::reference::bsdf::facet::facet;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::reflection::{reflect_about, reflection_half_vector, reflection_lobe};
use crate::reference::bsdf::refraction::refract_about;
use crate::reference::bsdf::rough::{rough_draw, rough_reflects};
use crate::reference::bsdf::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DIFFUSE, LOBE_REFLECTION, LOBE_TRANSMISSION,
    sample_or_none,
};
use crate::reference::bsdf::transmission::{transmission_half_vector, transmission_lobe};
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// Value and density of `wi` whose micro-normal is `m`.
pub fn rough_dielectric_at<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfValue<F> {
    let x = facet(settings, at, wi, m);
    let lobe = if wi.z > F::zero() {
        reflection_lobe(at, wi, x)
    } else {
        transmission_lobe(settings, at, wi, x)
    };
    with_diffuse(settings, at, wi, lobe)
}

/// Kd with probability p_d; else a micro-normal m, about which light is reflected with probability R(wo·m) and
/// refracted otherwise (model.md, "Sampling a direction"). Weight value·|N·wi|/density by the m that was drawn.
pub fn rough_dielectric_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let draw = rough_draw(settings, at, random);
    let diffuse = draw.diffuse;
    let reflects = rough_reflects(settings, at, draw, random);
    let leaving = if reflects {
        reflect_about(at.wo, draw.m, draw.c)
    } else {
        refract_about(at, draw.m, draw.c)
    };
    let wi = if diffuse {
        diffuse_direction(random.d)
    } else {
        leaving
    };
    let m = if diffuse {
        reflection_half_vector(at.wo, wi)
    } else {
        draw.m
    };
    let right_side = if reflects {
        wi.z > F::zero()
    } else {
        wi.z < F::zero()
    };
    let valid = diffuse || (draw.c > F::zero() && right_side);
    let lobe = if reflects {
        LOBE_REFLECTION
    } else {
        LOBE_TRANSMISSION
    };
    let value = rough_dielectric_at(settings, at, wi, m);
    sample_or_none(valid, wi, value, if diffuse { LOBE_DIFFUSE } else { lobe })
}

/// Kd/π + E_r on wo's side, E_t on the other, by the half vector that joins `wo` and `wi` (model.md,
/// "Density and value").
pub fn rough_dielectric_eval<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
) -> BsdfValue<F> {
    let m = if wi.z > F::zero() {
        reflection_half_vector(at.wo, wi)
    } else {
        transmission_half_vector(at, wi)
    };
    rough_dielectric_at(settings, at, wi, m)
}

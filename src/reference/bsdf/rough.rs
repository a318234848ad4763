//! The code that kinds with micro-normals share: how a sample begins, and their reflecting side. Twin of
//! `shaders/bsdf/rough.glsl`.

use super::choice::reflect_probability;
use super::diffuse::mixed::{diffuse_chosen, diffuse_direction, with_diffuse};
use super::facet::facet;
use super::fresnel::fresnel;
use super::interaction::{Interaction, carried_mean};
use super::normals::normals_sample;
use super::reflection::{reflect_about, reflection_half_vector, reflection_lobe};
use super::sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DIFFUSE, LOBE_REFLECTION, sample_or_none,
};
use crate::reference::math::{Real, Vec3, dot3};
use crate::settings::Settings;

/// The first draws of a sample of a rough surface.
#[derive(Clone, Copy, Debug)]
pub struct RoughDraw<F> {
    /// The diffuse lobe was chosen.
    pub diffuse: bool,
    /// A micro-normal, for either lobe; wo may be unable to see it.
    pub m: Vec3<F>,
    /// wo·m
    pub c: F,
}

/// The choice between Kd and the rest, and a micro-normal (model.md, "Sampling a direction").
pub fn rough_draw<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> RoughDraw<F> {
    let m = normals_sample(settings, at, random.m);
    RoughDraw {
        diffuse: diffuse_chosen(settings, at, random.lobe),
        m,
        c: dot3(at.wo, m),
    }
}

/// Whether the drawn micro-normal reflects, with probability R(c); else it refracts.
pub fn rough_reflects<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    draw: RoughDraw<F>,
    random: BsdfRandom<F>,
) -> bool {
    let f_mean = carried_mean(at, fresnel(at, draw.c));
    random.reflect < reflect_probability(settings, at, draw.c, f_mean)
}

/// Value and density of `wi` on wo's side, whose micro-normal is `m`: Kd/π and E_r.
pub fn rough_reflection_at<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfValue<F> {
    let x = facet(settings, at, wi, m);
    with_diffuse(settings, at, wi, reflection_lobe(at, wi, x))
}

/// The sample on wo's side: a diffuse direction, or wo mirrored about the drawn micro-normal.
pub fn rough_reflection_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    draw: RoughDraw<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    let diffuse = draw.diffuse;
    let wi = if diffuse {
        diffuse_direction(random.d)
    } else {
        reflect_about(at.wo, draw.m, draw.c)
    };
    let m = if diffuse {
        reflection_half_vector(at.wo, wi)
    } else {
        draw.m
    };
    let valid = (diffuse || draw.c > F::zero()) && wi.z > F::zero();
    let lobe = if diffuse {
        LOBE_DIFFUSE
    } else {
        LOBE_REFLECTION
    };
    sample_or_none(valid, wi, rough_reflection_at(settings, at, wi, m), lobe)
}

//! Opaque: a rough reflection, and Kd; twin of `shaders/bsdf/kind/opaque.glsl`.

use crate::reference::bsdf::diffuse::mixed::{diffuse_chosen, diffuse_direction, with_diffuse};
use crate::reference::bsdf::facet::facet;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::normals::normals_sample;
use crate::reference::bsdf::reflection::{reflect_about, reflection_half_vector, reflection_lobe};
use crate::reference::bsdf::sample::{
    BsdfSample, BsdfValue, LOBE_DIFFUSE, LOBE_REFLECTION, sample_or_none,
};
use crate::reference::math::{Real, Vec3, dot3};
use crate::settings::Settings;

/// Value and density of `wi` whose micro-normal is `m`.
pub fn opaque_at<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfValue<F> {
    let x = facet(settings, at, wi, m);
    with_diffuse(settings, at, wi, reflection_lobe(at, wi, x))
}

/// Kd with probability p_d, else wo mirrored about a micro-normal (model page, sections 5.1 to 5.4).
pub fn opaque_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    u_lobe: F,
    _u_reflect: F,
    u_m: [F; 2],
    u_d: [F; 2],
) -> BsdfSample<F> {
    let diffuse = diffuse_chosen(settings, at, u_lobe);
    let drawn = normals_sample(settings, at, u_m);
    let c = dot3(at.wo, drawn);
    let wi = if diffuse {
        diffuse_direction(u_d)
    } else {
        reflect_about(at.wo, drawn, c)
    };
    let m = if diffuse {
        reflection_half_vector(at.wo, wi)
    } else {
        drawn
    };
    let valid = (diffuse || c > F::zero()) && wi.z > F::zero();
    let lobe = if diffuse {
        LOBE_DIFFUSE
    } else {
        LOBE_REFLECTION
    };
    sample_or_none(valid, wi, opaque_at(settings, at, wi, m), lobe)
}

/// Kd/π + E_r on wo's side, by the half vector (model page, section 6).
pub fn opaque_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    opaque_at(settings, at, wi, reflection_half_vector(at.wo, wi))
}

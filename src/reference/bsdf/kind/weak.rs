//! A rough interface that hardly refracts, α·|n − 1| < 1e-5; twin of `shaders/bsdf/kind/weak.glsl`.
//!
//! The transmitted lobe is so narrow that f32 cannot tell its density at a given direction. It is drawn as
//! that of any rough interface, but counts as a delta lobe: its weight needs no Jacobian, and it is not connected
//! to lights. Reflection is the rough one, with a density.

use crate::reference::bsdf::choice::reflect_probability;
use crate::reference::bsdf::diffuse::mixed::{
    diffuse_chosen, diffuse_direction, facet_probability, with_diffuse,
};
use crate::reference::bsdf::facet::facet;
use crate::reference::bsdf::fresnel::fresnel;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::normals::normals_sample;
use crate::reference::bsdf::reflection::{reflect_about, reflection_half_vector, reflection_lobe};
use crate::reference::bsdf::refraction::refract_about;
use crate::reference::bsdf::sample::{
    BsdfSample, BsdfValue, LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION, LOBE_TRANSMISSION,
    sample_or_none,
};
use crate::reference::bsdf::transmission::transmitted;
use crate::reference::math::{Real, Vec3, dot3, mean3};
use crate::settings::Settings;

/// Value and density of `wi` on wo's side, whose micro-normal is `m`.
pub fn weak_at<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfValue<F> {
    let x = facet(settings, at, wi, m);
    with_diffuse(settings, at, wi, reflection_lobe(at, wi, x))
}

/// Transmission through the micro-normal `m`: D G (1 − F) c/wo.z over pm (1 − R), each per solid angle of m.
pub fn weak_transmission<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> BsdfSample<F> {
    let x = facet(settings, at, wi, m);
    let p_m = facet_probability(settings, at);
    let value = BsdfValue {
        value: transmitted(settings, at, x),
        pdf: p_m * x.pm * (F::one() - x.p_reflect),
    };
    let valid = x.c > F::zero() && at.wo.z > F::zero() && wi.z < F::zero();
    sample_or_none(valid, wi, value, LOBE_TRANSMISSION | LOBE_DELTA)
}

/// As [`dielectric_sample`](super::dielectric::dielectric_sample) draws, with refraction as a delta lobe.
pub fn weak_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    u_lobe: F,
    u_reflect: F,
    u_m: [F; 2],
    u_d: [F; 2],
) -> BsdfSample<F> {
    let diffuse = diffuse_chosen(settings, at, u_lobe);
    let drawn = normals_sample(settings, at, u_m);
    let c = dot3(at.wo, drawn);
    let f_mean = mean3(fresnel(at, c));
    let reflects = u_reflect < reflect_probability(settings, at, c, f_mean);
    if diffuse || reflects {
        let mirrored = reflect_about(at.wo, drawn, c);
        let wi = if diffuse {
            diffuse_direction(u_d)
        } else {
            mirrored
        };
        let half = reflection_half_vector(at.wo, wi);
        let m = if diffuse { half } else { drawn };
        let valid = (diffuse || c > F::zero()) && wi.z > F::zero();
        let lobe = if diffuse {
            LOBE_DIFFUSE
        } else {
            LOBE_REFLECTION
        };
        sample_or_none(valid, wi, weak_at(settings, at, wi, m), lobe)
    } else {
        weak_transmission(settings, at, refract_about(at, drawn, c), drawn)
    }
}

/// Kd/π + E_r on wo's side; what is refracted has no density.
pub fn weak_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    weak_at(settings, at, wi, reflection_half_vector(at.wo, wi))
}

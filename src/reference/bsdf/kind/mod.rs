//! Kinds of material, each from its lobes; the kernels' slot `<bsdf>`. All kinds' functions take the same
//! arguments.
//!
//! A kind's `_at` function takes the micro-normal: sampling hands it the one that was drawn, evaluation the
//! half vector, which has lost digits where the surface is smooth.

pub mod dielectric;
pub mod diffuse;
pub mod glass;
pub mod mirror;
pub mod opaque;
pub mod weak;

use super::interaction::Interaction;
use super::sample::{BsdfRandom, BsdfSample, BsdfValue, no_sample, no_value};
use crate::prepared::MaterialKind;
use crate::reference::math::{Real, Vec3};
use crate::settings::Settings;

/// Draws `wi`.
pub fn bsdf_sample<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    random: BsdfRandom<F>,
) -> BsdfSample<F> {
    match at.material.kind {
        MaterialKind::Black | MaterialKind::Nothing => no_sample(),
        MaterialKind::Diffuse => diffuse::diffuse_sample(settings, at, random),
        MaterialKind::Opaque => opaque::opaque_sample(settings, at, random),
        MaterialKind::Mirror => mirror::mirror_sample(settings, at, random),
        MaterialKind::Dielectric => dielectric::dielectric_sample(settings, at, random),
        MaterialKind::Glass => glass::glass_sample(settings, at, random),
        MaterialKind::Weak => weak::weak_sample(settings, at, random),
    }
}

/// Value·|N·wi| and density of `wi`, for the lobes that have a density.
pub fn bsdf_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    match at.material.kind {
        MaterialKind::Black | MaterialKind::Nothing => no_value(),
        MaterialKind::Diffuse => diffuse::diffuse_eval(settings, at, wi),
        MaterialKind::Opaque => opaque::opaque_eval(settings, at, wi),
        MaterialKind::Mirror => mirror::mirror_eval(settings, at, wi),
        MaterialKind::Dielectric => dielectric::dielectric_eval(settings, at, wi),
        MaterialKind::Glass => glass::glass_eval(settings, at, wi),
        MaterialKind::Weak => weak::weak_eval(settings, at, wi),
    }
}

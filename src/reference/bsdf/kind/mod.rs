//! Kinds of material, each from its lobes; the kernels' slot `<bsdf>`. All kinds' functions take the same
//! arguments.
//!
//! A kind's `_at` function takes the micro-normal: sampling passes the one that was drawn, evaluation the half vector,
//! which has lost digits where the surface is smooth.

pub mod diffuse;
pub mod glossy;
pub mod mirror;
pub mod rough_dielectric;
pub mod smooth_dielectric;
pub mod weak_dielectric;

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
        MaterialKind::Black | MaterialKind::NullInterface => no_sample(),
        MaterialKind::Diffuse => diffuse::diffuse_sample(settings, at, random),
        MaterialKind::Glossy => glossy::glossy_sample(settings, at, random),
        MaterialKind::Mirror => mirror::mirror_sample(settings, at, random),
        MaterialKind::RoughDielectric => {
            rough_dielectric::rough_dielectric_sample(settings, at, random)
        }
        MaterialKind::SmoothDielectric => {
            smooth_dielectric::smooth_dielectric_sample(settings, at, random)
        }
        MaterialKind::WeakDielectric => {
            weak_dielectric::weak_dielectric_sample(settings, at, random)
        }
    }
}

/// Value·|N·wi| and density of `wi`, for the lobes that have a density.
pub fn bsdf_eval<F: Real>(settings: &Settings, at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    match at.material.kind {
        MaterialKind::Black | MaterialKind::NullInterface => no_value(),
        MaterialKind::Diffuse => diffuse::diffuse_eval(settings, at, wi),
        MaterialKind::Glossy => glossy::glossy_eval(settings, at, wi),
        MaterialKind::Mirror => mirror::mirror_eval(settings, at, wi),
        MaterialKind::RoughDielectric => rough_dielectric::rough_dielectric_eval(settings, at, wi),
        MaterialKind::SmoothDielectric => {
            smooth_dielectric::smooth_dielectric_eval(settings, at, wi)
        }
        MaterialKind::WeakDielectric => weak_dielectric::weak_dielectric_eval(settings, at, wi),
    }
}

//! The reasons why parts are not in the kernel.

use super::Subject;
use vkpt::features::{LightPick, Member};
use vkpt::prepared::{LightKind, MaterialKind, ShapeKind};
use vkpt::settings::{Distribution, DistributionRule, Fresnel};

/// A few words that complete "it is not in the kernel: …".
pub fn reason(subject: &Subject, member: Member) -> String {
    let words = match member {
        Member::Shape(kind) | Member::InBvh(kind) => {
            return format!("the scene has no {}", kind.description().name);
        }
        Member::Light(kind) => return light(subject, kind),
        Member::Material(kind) => material(kind),
        Member::DiffuseBeside => "no surface has Kd and also Ks or Kt",
        Member::Distribution(which) => distribution(subject, which),
        Member::Fresnel(form) => fresnel(subject, form),
        Member::LightPick(pick) => match (subject.job.prepared.lights.len(), pick) {
            (0, _) => "the scene has no light",
            (1, _) => "one light needs no choice",
            (_, LightPick::Power) => "lights are picked by contribution",
            (_, LightPick::Every) => "too many lights to sample each",
            (_, LightPick::Tree) => "few lights need no tree",
        },
        Member::Absorption(_) => "no surface transmits part of the light: Kt is 0 or 1",
        Member::ShadingNormals => match subject.plan.features.shapes.contains(&ShapeKind::Mesh) {
            true => "no mesh file has normals",
            false => "the scene has no mesh",
        },
        Member::Aims => "nothing mirrors or refracts: there are no caustics",
        Member::Lens => "the camera is a pinhole",
        Member::Covered(kind) => {
            return format!(
                "no face of a {} coincides with an earlier one",
                kind.description().name
            );
        }
    };
    words.to_owned()
}

fn light(subject: &Subject, kind: LightKind) -> String {
    let pictured = subject.job.prepared.surroundings.is_some();
    match (kind.shape(), kind) {
        (Some(shape), _) => format!("no {} is a light", shape.description().name),
        (None, LightKind::Surroundings) => "the scene has no picture of surroundings".to_owned(),
        (None, _) if pictured => "a picture of surroundings replaces it".to_owned(),
        (None, _) => "the background is black".to_owned(),
    }
}

/// By the limits of model.md, "Limits".
fn material(kind: MaterialKind) -> &'static str {
    match kind {
        MaterialKind::Black => "no shape is a light or perfectly black",
        MaterialKind::Diffuse => "no opaque surface has only Kd",
        MaterialKind::Glossy => "no opaque surface has a Ks and is rough",
        MaterialKind::Mirror => "no opaque surface has a Ks and is perfectly smooth",
        MaterialKind::RoughDielectric => "no surface with a Kt is rough",
        MaterialKind::SmoothDielectric => "no surface with a Kt is perfectly smooth",
        MaterialKind::WeakDielectric => "no rough surface with a Kt has |ior - 1| < 1e-5 / alpha",
        MaterialKind::NullInterface => "no surface with a Kt has the index 1",
    }
}

fn distribution(subject: &Subject, which: Distribution) -> &'static str {
    let rough = !subject.plan.features.distributions.is_empty();
    match (rough, subject.job.settings.model.distribution, which) {
        (false, ..) => "nothing is rough",
        (true, DistributionRule::Always(_), _) => "a flag selects another for every surface",
        (true, _, Distribution::Phong) => {
            "no rough surface has an exponent (alpha above 1) or the word"
        }
        (true, _, Distribution::Beckmann) => "no word selects it",
        (true, _, Distribution::Ggx) => {
            "no rough surface has a width (alpha up to 1) without a word"
        }
    }
}

fn fresnel(subject: &Subject, form: Fresnel) -> &'static str {
    match (subject.plan.features.fresnel.is_empty(), form) {
        (true, _) => "nothing reflects like a mirror, smooth or rough",
        (false, Fresnel::Schlick) => "every reflecting surface uses the exact form",
        (false, Fresnel::Exact) => "no surface with a Kt has the word, and no flag selects it",
    }
}

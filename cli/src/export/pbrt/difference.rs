//! Features for which pbrt-v4 uses another model: the picture is nearly the same, but not equal.

use glam::DVec3;

use crate::export::Subject;
use crate::export::remark::{Remark, gathered};
use crate::export::seen::{absorbs, used};
use vkpt::prepared::{Material, MaterialKind};

/// The difference.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Difference {
    #[error(
        "a colour: pbrt converts it to a smooth spectrum, and products of spectra differ from those of RGB; grey is the same"
    )]
    Colour,
    #[error(
        "a rough surface: pbrt masks both directions jointly, by 1/(1 + \u{39b}o + \u{39b}i), and is a little brighter"
    )]
    Masking,
}

/// Each difference once, at its first line.
pub fn all(subject: &Subject) -> Vec<Remark<String>> {
    let scene = subject.scene;
    let mut all = Vec::new();
    if is_coloured(scene.background) {
        all.push(Remark::new(scene.background_line, Difference::Colour));
    }
    for material in used(subject.prepared) {
        let of = |difference| Remark::new(material.line, difference);
        all.extend(has_colour(material).then(|| of(Difference::Colour)));
        all.extend(is_rough(material).then(|| of(Difference::Masking)));
    }
    gathered(all).into_iter().map(Remark::as_text).collect()
}

fn has_colour(material: &Material) -> bool {
    let medium = match absorbs(material) {
        true => material.sigma,
        false => DVec3::ZERO,
    };
    [material.kd, material.radiance, medium]
        .into_iter()
        .any(is_coloured)
}

fn is_coloured(colour: DVec3) -> bool {
    colour != DVec3::splat(colour.x)
}

fn is_rough(material: &Material) -> bool {
    matches!(
        material.kind,
        MaterialKind::Glossy | MaterialKind::RoughDielectric
    )
}

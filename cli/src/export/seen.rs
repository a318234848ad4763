//! The visible part of a scene: all shapes except index-matched interfaces without absorption.

use glam::DVec3;

use super::Subject;
use vkpt::prepared::{Material, MaterialKind, Prepared};
use vkpt::scene::Shape;

/// Whether light is absorbed inside.
pub fn absorbs(material: &Material) -> bool {
    Prepared::is_transmissive(material) && material.sigma != DVec3::ZERO
}

/// Whether it has any visible effect: an index-matched interface without absorption has none.
pub fn is_there(material: &Material) -> bool {
    material.kind != MaterialKind::NullInterface || absorbs(material)
}

/// The materials of visible shapes.
pub fn used(prepared: &Prepared) -> impl Iterator<Item = &Material> {
    let mut has_shape = vec![false; prepared.materials.len()];
    for shape in &prepared.shapes {
        has_shape[shape.material as usize] = true;
    }
    let materials = prepared.materials.iter().zip(has_shape);
    materials
        .filter(|(material, has_shape)| *has_shape && is_there(material))
        .map(|(material, _)| material)
}

/// The visible shapes of the scene, with their materials.
pub fn seen<'a>(subject: &Subject<'a>) -> impl Iterator<Item = (&'a Shape, &'a Material)> {
    let materials = &subject.prepared.materials;
    let all = subject.scene.shapes.iter();
    all.map(|shape| (shape, &materials[shape.material]))
        .filter(|(_, material)| is_there(material))
}

//! What can be seen of a scene: all shapes but those whose surface is not there.

use glam::DVec3;

use super::Subject;
use vkpt::prepared::{Material, MaterialKind, Prepared};
use vkpt::scene::Shape;

/// Whether light is absorbed inside.
pub fn absorbs(material: &Material) -> bool {
    Prepared::is_transmissive(material) && material.sigma != DVec3::ZERO
}

/// Whether there is anything to be seen of it: a null interface without absorption is not there.
pub fn is_there(material: &Material) -> bool {
    material.kind != MaterialKind::NullInterface || absorbs(material)
}

/// The materials of shapes that can be seen.
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

/// The shapes of the scene that can be seen, with what they are made of.
pub fn seen<'a>(subject: &Subject<'a>) -> impl Iterator<Item = (&'a Shape, &'a Material)> {
    let materials = &subject.prepared.materials;
    let all = subject.scene.shapes.iter();
    all.map(|shape| (shape, &materials[shape.material]))
        .filter(|(_, material)| is_there(material))
}

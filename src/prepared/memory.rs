//! What a scene will take of the host's memory, known as soon as it is read.

use super::Prepared;
use crate::film::Film;
use crate::scene::{Geometry, Scene};

/// Bytes a triangle at the peak, which comes while faces that coincide are looked for or while the hierarchy is built
/// (docs/records/2026-11-29-scale.md).
const FLAT: u64 = 450;
/// Where a mesh has normals.
const SMOOTH: u64 = 550;
/// Bytes a texel: three values and a count, and the same on the device, which with a CPU driver is the host's memory too.
const TEXEL: u64 = 32;

/// What takes most of the memory, from reading to rendering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Footprint {
    pub triangles: u64,
    /// A mesh has normals.
    pub smooth: bool,
    /// Of surroundings.
    pub texels: u64,
}

impl Footprint {
    pub fn of(scene: &Scene) -> Self {
        let meshes = (scene.shapes.iter()).filter_map(|shape| match &shape.geometry {
            Geometry::Mesh(mesh) => Some(mesh),
            _ => None,
        });
        let surroundings = scene.surroundings.as_ref();
        Self {
            triangles: meshes.clone().map(|mesh| mesh.triangles.len() as u64).sum(),
            smooth: meshes.clone().any(|mesh| mesh.normals.is_some()),
            texels: surroundings.map_or(0, |s| texels(&s.picture)),
        }
    }

    /// The same of a prepared scene.
    pub fn of_prepared(prepared: &Prepared) -> Self {
        let surroundings = prepared.surroundings.as_ref();
        Self {
            triangles: prepared.primitives.triangles.len() as u64,
            smooth: !prepared.primitives.normals.is_empty(),
            texels: surroundings.map_or(0, |s| texels(&s.picture)),
        }
    }

    /// About the most bytes at once.
    pub fn peak(self) -> u64 {
        self.triangles * if self.smooth { SMOOTH } else { FLAT } + self.texels * TEXEL
    }
}

fn texels(picture: &Film) -> u64 {
    picture.rgb.len() as u64
}

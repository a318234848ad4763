//! Estimates a scene's demand for host memory as soon as it is read.

use super::Prepared;
use crate::film::Film;
use crate::scene::{Geometry, Scene};

/// Bytes per triangle at the peak, which occurs during the search for coincident faces or the construction of the
/// hierarchy (docs/records/2026-11-29-scale.md).
const FLAT: u64 = 450;
/// The same if a mesh has normals.
const SMOOTH: u64 = 550;
/// Bytes per texel: three values and a count, and the same again on the device, whose memory is the host's with a CPU
/// driver.
const TEXEL: u64 = 32;

/// The largest consumers of memory, from reading to rendering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Footprint {
    pub triangles: u64,
    /// A mesh has normals.
    pub smooth: bool,
    /// Texels of the surroundings.
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

    /// The same for a prepared scene.
    pub fn of_prepared(prepared: &Prepared) -> Self {
        let surroundings = prepared.surroundings.as_ref();
        Self {
            triangles: prepared.primitives.triangles.len() as u64,
            smooth: !prepared.primitives.normals.is_empty(),
            texels: surroundings.map_or(0, |s| texels(&s.picture)),
        }
    }

    /// The approximate peak in bytes.
    pub fn peak(self) -> u64 {
        self.triangles * if self.smooth { SMOOTH } else { FLAT } + self.texels * TEXEL
    }
}

fn texels(picture: &Film) -> u64 {
    picture.rgb.len() as u64
}

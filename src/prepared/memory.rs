//! What a scene will take of the host's memory, known as soon as it is read.

use crate::scene::{Geometry, Scene};

/// Bytes a triangle at the peak, which comes while faces that coincide are looked for or while the hierarchy is built
/// (benches/2026-11-29-scale.md).
const FLAT: u64 = 450;
/// Where a mesh has normals.
const SMOOTH: u64 = 550;

/// The number of triangles of a scene, and about the most bytes that they take at once from reading to rendering.
pub fn triangles_and_peak(scene: &Scene) -> (u64, u64) {
    let meshes = (scene.shapes.iter()).filter_map(|shape| match &shape.geometry {
        Geometry::Mesh(mesh) => Some(mesh),
        _ => None,
    });
    let triangles = meshes.clone().map(|mesh| mesh.triangles.len() as u64).sum();
    let smooth = meshes.clone().any(|mesh| mesh.normals.is_some());
    (triangles, peak(triangles, smooth))
}

/// The same of a prepared scene.
pub(super) fn peak(triangles: u64, smooth: bool) -> u64 {
    triangles * if smooth { SMOOTH } else { FLAT }
}

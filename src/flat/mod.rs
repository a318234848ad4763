//! Prepared scene → the GPU's buffers. The content of a buffer does not depend on the kernel that reads it; the caller,
//! who knows the features, requests only the buffers that are needed.

pub mod bvh;

use glam::DVec3;

use crate::layout::OnDevice;
use crate::prepared::{Prepared, Surroundings, device};

/// The device form of these records.
pub fn records<T: OnDevice>(records: &[T]) -> Vec<T::Record> {
    records.iter().map(OnDevice::record).collect()
}

/// The camera, with the seed of the sampler.
pub fn camera(prepared: &Prepared, seed: u32) -> device::Camera {
    device::Camera {
        seed,
        ..prepared.camera.record()
    }
}

/// The axes and size of the surroundings.
pub fn surroundings(surroundings: &Surroundings) -> device::Surroundings {
    surroundings.map.record()
}

/// Nine floats per triangle: its corners.
pub fn triangles(prepared: &Prepared) -> Vec<[[f32; 3]; 3]> {
    prepared
        .primitives
        .triangles
        .iter()
        .map(|t| t.v.map(f32x3))
        .collect()
}

/// The shape of each triangle.
pub fn triangle_shapes(prepared: &Prepared) -> Vec<u32> {
    prepared
        .primitives
        .triangles
        .iter()
        .map(|t| t.shape)
        .collect()
}

/// Nine floats per triangle: the shading normals of its corners; zero if its mesh has none.
pub fn normals(prepared: &Prepared) -> Vec<[[f32; 3]; 3]> {
    prepared
        .primitives
        .normals
        .iter()
        .map(|n| n.map(f32x3))
        .collect()
}

fn f32x3(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

//! Meshes as binary PLY files, each triangle at its place in the scene; and boxes as meshes.

use std::borrow::Cow;

use glam::{BVec3, DVec3};

use super::seen::seen;
use super::{Beside, Subject};
use vkpt::prepared::{Material, Prepared};
use vkpt::scene::{Geometry, Mesh, flip, signed_volume};

/// The triangles of a box, counter-clockwise seen from outside: two for each face, with the corners of [`corners`].
pub const BOX: [[u32; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

/// The corners of the box from `lo` to `hi`: bit 0 of a corner's number selects x of `hi`, bit 1 y, bit 2 z.
pub fn corners(lo: DVec3, hi: DVec3) -> [DVec3; 8] {
    std::array::from_fn(|i| {
        let is_hi = BVec3::from_array([0, 1, 2].map(|bit| i >> bit & 1 == 1));
        DVec3::select(is_hi, hi, lo)
    })
}

/// The file name of a mesh, given its line.
pub fn file_name(stem: &str, line: usize) -> String {
    format!("{stem}-{line}.ply")
}

/// The files of all visible meshes.
pub fn files(subject: &Subject) -> Vec<Beside> {
    let meshes = seen(subject).filter_map(|(shape, material)| match &shape.geometry {
        Geometry::Mesh(mesh) => Some((shape.line, outwards(mesh, material))),
        _ => None,
    });
    let file = |(line, mesh): (usize, Cow<Mesh>)| Beside {
        name: file_name(subject.stem, line),
        bytes: ply(&mesh),
    };
    meshes.map(file).collect()
}

/// Glass and lights have an outside: their triangles are wound counter-clockwise as seen from there.
pub fn outwards<'m>(mesh: &'m Mesh, material: &Material) -> Cow<'m, Mesh> {
    let has_outside = Prepared::is_transmissive(material) || material.radiance != DVec3::ZERO;
    if !has_outside || signed_volume(mesh) >= 0.0 {
        return Cow::Borrowed(mesh);
    }
    let mut turned = mesh.clone();
    flip(&mut turned);
    Cow::Owned(turned)
}

fn ply(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.len(),
        mesh.triangles.len()
    )
    .into_bytes();
    for p in &mesh.positions {
        let p = mesh.translate + mesh.scale * (mesh.rotate * p);
        for x in p.as_vec3().to_array() {
            bytes.extend(x.to_le_bytes());
        }
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        for corner in triangle {
            bytes.extend(corner.to_le_bytes());
        }
    }
    bytes
}

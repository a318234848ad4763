//! Meshes as binary PLY files, each triangle where the scene has it.

use std::borrow::Cow;

use glam::DVec3;

use super::seen::seen;
use super::{Beside, Subject};
use crate::prepared::{Material, Prepared};
use crate::scene::{Geometry, Mesh, flip, signed_volume};

/// The name of the mesh of a line.
pub fn file_name(stem: &str, line: usize) -> String {
    format!("{stem}-{line}.ply")
}

/// Those of all meshes that can be seen.
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

/// Glass and lights have an outside: their triangles are wound as one sees them from there.
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

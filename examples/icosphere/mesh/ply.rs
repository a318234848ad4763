//! Writes PLY files (Turk, *The PLY Polygon File Format*, 1994), binary and little endian.

use glam::DVec3;

use super::Icosphere;

/// The bytes of a file: positions in single precision and, if given, a normal for each.
pub fn bytes(mesh: &Icosphere, normals: Option<&[DVec3]>) -> Vec<u8> {
    let (vertices, faces) = (mesh.positions.len(), mesh.triangles.len());
    let names = match normals {
        Some(_) => vec!["x", "y", "z", "nx", "ny", "nz"],
        None => vec!["x", "y", "z"],
    };
    let properties: String = names
        .iter()
        .map(|name| format!("property float {name}\n"))
        .collect();
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\n{properties}\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let mut push = |v: DVec3| {
        bytes.extend(
            v.as_vec3()
                .to_array()
                .into_iter()
                .flat_map(f32::to_le_bytes),
        )
    };
    for (i, position) in mesh.positions.iter().enumerate() {
        push(*position);
        normals.iter().for_each(|normals| push(normals[i]));
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|i| i.to_le_bytes()));
    }
    bytes
}

//! Mesh files.

use std::path::Path;

use glam::{DQuat, DVec3};
use vkpt::scene::{Mesh, MeshFile, edges, flip, parse_mesh, signed_volume};

/// A PLY file is a whole mesh, or refused.
pub fn ply(bytes: &[u8]) {
    mesh(bytes, "none/mesh.ply");
}

/// An OBJ file is a whole mesh, or refused.
pub fn obj(bytes: &[u8]) {
    mesh(bytes, "none/mesh.obj");
}

/// A glTF or GLB file is a whole mesh, or refused. It has no external buffers.
pub fn gltf(bytes: &[u8]) {
    mesh(bytes, "none/mesh.gltf");
}

fn mesh(bytes: &[u8], path: &str) {
    match parse_mesh(bytes, Path::new(path)) {
        Ok(file) => {
            promises_kept(&file);
            take_up(file, path);
        }
        Err(error) => super::has_message(&error),
    }
}

/// Checks a mesh for the promises of [`MeshFile`].
fn promises_kept(file: &MeshFile) {
    let finite = |p: &DVec3| p.as_vec3().is_finite();
    assert!(file.positions.iter().all(finite), "positions");
    let vertices = file.positions.len();
    assert!(!file.triangles.is_empty(), "no triangles");
    let corners = file.triangles.as_flattened();
    assert!(corners.iter().all(|i| (*i as usize) < vertices), "indices");
    if let Some(normals) = &file.normals {
        assert_eq!(normals.len(), vertices);
        let unit = |n: &DVec3| *n == DVec3::ZERO || n.is_normalized();
        assert!(normals.iter().all(unit), "normals");
    }
    file.warnings.iter().for_each(|w| super::has_message(w));
}

/// Uses a mesh as a scene does.
fn take_up(file: MeshFile, path: &str) {
    let mut mesh = Mesh {
        path: path.into(),
        files: file.files,
        positions: file.positions,
        normals: file.normals,
        triangles: file.triangles,
        translate: DVec3::ZERO,
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    };
    let (found, volume) = (edges(&mesh), signed_volume(&mesh));
    flip(&mut mesh);
    assert_eq!(edges(&mesh), found, "edges of the flipped mesh");
    assert!(volume.is_finite(), "volume {volume}");
}

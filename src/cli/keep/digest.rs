//! What tells one scene from another, the files that it names included.

use std::fs::File;
use std::io;
use std::path::Path;

use crate::scene::{Geometry, Scene};

/// A digest of the scene's text and of the bytes of all its meshes and of its surroundings, in hexadecimal: BLAKE3 of their
/// digests, in order.
pub fn digest(text: &str, scene: &Scene) -> io::Result<String> {
    let mut all = blake3::Hasher::new();
    all.update(blake3::hash(text.as_bytes()).as_bytes());
    for shape in &scene.shapes {
        if let Geometry::Mesh(mesh) = &shape.geometry {
            for path in [&mesh.path].into_iter().chain(&mesh.files) {
                all.update(of_file(path)?.as_bytes());
            }
        }
    }
    if let Some(surroundings) = &scene.surroundings {
        all.update(of_file(&surroundings.path)?.as_bytes());
    }
    Ok(all.finalize().to_hex().to_string())
}

fn of_file(path: &Path) -> io::Result<blake3::Hash> {
    let mut hasher = blake3::Hasher::new();
    hasher.update_reader(File::open(path)?)?;
    Ok(hasher.finalize())
}

//! A digest of a scene, including the files that it names.

use std::collections::HashMap;
use std::fs::File;
use std::io;
use std::path::Path;

use vkpt::scene::{Geometry, Scene};

/// A digest of the scene's text and of the bytes of all its meshes and of its surroundings, in hexadecimal: BLAKE3 of their
/// digests, in order. The text of a glTF file's scene contains a digest of that file; the buffers next to it count as meshes.
pub fn digest(text: &str, scene: &Scene) -> io::Result<String> {
    let mut all = blake3::Hasher::new();
    all.update(blake3::hash(text.as_bytes()).as_bytes());
    // A file that is a whole scene has many shapes.
    let mut known = HashMap::new();
    let mut add = |path: &Path| {
        let hash = match known.get(path) {
            Some(hash) => *hash,
            None => of_file(path)?,
        };
        known.insert(path.to_owned(), hash);
        all.update(hash.as_bytes());
        io::Result::Ok(())
    };
    for shape in &scene.shapes {
        if let Geometry::Mesh(mesh) = &shape.geometry {
            let own = Some(&mesh.path).filter(|path| **path != scene.path);
            for path in own.into_iter().chain(&mesh.files) {
                add(path)?;
            }
        }
    }
    if let Some(surroundings) = &scene.surroundings {
        add(&surroundings.path)?;
    }
    Ok(all.finalize().to_hex().to_string())
}

fn of_file(path: &Path) -> io::Result<blake3::Hash> {
    let mut hasher = blake3::Hasher::new();
    hasher.update_reader(File::open(path)?)?;
    Ok(hasher.finalize())
}

//! A glTF file as a scene; docs/gltf.md has the mapping.
//!
//! [`gltf`](super::mesh::gltf) has read and checked nodes and triangles; this module adds materials, the view and the
//! lights. Messages cannot refer to lines of the file, so they refer to lines of a [`listing`].

mod ball;
mod build;
mod document;
mod lamps;
mod left_out;
mod legal;
mod listing;
mod materials;
mod shapes;
mod surface;
mod unread;
mod view;

use std::path::Path;

use self::build::Build;
use super::log::Log;
use super::mesh::foreign;
use super::mesh::gltf::{not_understood, read_whole};
use super::{Errors, Read};

/// Whether a file with this name is read as glTF.
pub(super) fn is_name(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    ending.is_some_and(|ending| ending == "gltf" || ending == "glb")
}

/// Whether these bytes are a GLB, whatever the file's name.
pub(super) fn is_glb(bytes: &[u8]) -> bool {
    bytes.starts_with(b"glTF")
}

/// Reads the scene in `bytes`, with the view of the camera named `camera`, by default the first.
///
/// # Errors
/// As [`super::read`].
pub(super) fn read(
    bytes: &[u8],
    path: &Path,
    strict: bool,
    camera: Option<&str>,
) -> Result<Read, Errors> {
    let log = Log::new(path, String::new());
    let folder = path.parent().unwrap_or(Path::new(""));
    let whole = match foreign(bytes) {
        Some(what) => Err(what.to_owned()),
        None => read_whole(bytes, folder).map_err(|error| error.to_string()),
    };
    let read = whole.and_then(|whole| {
        let document = serde_json::from_str(&whole.json);
        Ok((document.map_err(|error| not_understood(&error))?, whole))
    });
    match read {
        Ok((document, whole)) => {
            let mut build = Build::new(log, path, bytes);
            let scene = build.scene(&document, &whole, camera);
            build.finish(scene, strict)
        }
        Err(what) => {
            let message = format!("{}: {what}", path.display());
            Err(log.fail(message))
        }
    }
}

//! Text → [`Scene`]: the course's scene format with vkpt's extensions, and glTF files through `model`. Knows no
//! buffers and no Vulkan.
//!
//! A file is read to its end whatever its errors, so that all of them are reported at once. `text` splits it into
//! lines and tokens, `commands` has a row for each command, `arguments` takes numbers off a line and checks them,
//! and each problem becomes a [`Diagnostic`].

mod arguments;
mod builder;
mod camera;
mod commands;
mod diagnostic;
mod field;
mod file_path;
mod foreign;
mod lens;
mod log;
mod material;
mod mesh;
mod mesh_check;
mod model;
mod number;
mod orientation;
mod shape;
mod surroundings;
mod text;
mod types;
mod view;

use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

pub use diagnostic::{Diagnostic, Errors, Place};
pub use mesh::{MESH_FORMATS, MeshError, MeshFile, parse_mesh, read_mesh};
pub use mesh_check::{Edges, edges, flip, open_edges, signed_volume};
pub use types::*;
pub use view::LARGEST_SIDE;

use log::Log;

/// A scene and its warnings.
#[derive(Clone, Debug)]
pub struct Read {
    pub scene: Scene,
    /// In file order; includes notes.
    pub warnings: Vec<Diagnostic>,
    /// The text that was read, line by line.
    pub text: String,
    /// `text` was generated: the file has other lines, or none.
    pub is_listing: bool,
}

/// Maximum length in bytes of a scene file.
const LONGEST_FILE: u64 = 256 << 20;

/// Reads a scene file and the meshes that it names, or a glTF file.
///
/// # Errors
/// All errors and warnings of the file, in file order; with `strict`, warnings count as errors.
pub fn read(path: &Path, strict: bool) -> Result<Read, Errors> {
    read_seen(path, strict, None)
}

/// Like [`read`], with the view of the glTF camera named `camera`, by default the first.
///
/// # Errors
/// As [`read`]; also if there is no such camera.
pub fn read_seen(path: &Path, strict: bool, camera: Option<&str>) -> Result<Read, Errors> {
    match File::open(path) {
        Ok(file) => read_from(file, path, strict, camera),
        Err(reason) => Err(unreadable(path, &reason)),
    }
}

/// Reads a scene from a stream; `path` is as for [`parse`], `camera` as for [`read_seen`].
///
/// # Errors
/// As [`read_seen`].
pub fn read_from(
    source: impl io::Read,
    path: &Path,
    strict: bool,
    camera: Option<&str>,
) -> Result<Read, Errors> {
    let mut bytes = Vec::new();
    let name = path.display();
    let refused = |why: String| Log::new(path, String::new()).fail(why);
    // A glTF file contains its meshes.
    let longest = match model::is_name(path) && path.is_file() {
        true => u64::MAX - 1,
        false => LONGEST_FILE,
    };
    source
        .take(longest + 1)
        .read_to_end(&mut bytes)
        .map_err(|reason| unreadable(path, &reason))?;
    if bytes.len() as u64 > longest {
        return Err(refused(format!(
            "{name} is longer than 256 MiB: this is not a scene file"
        )));
    }
    if model::is_name(path) || model::is_glb(&bytes) {
        return model::read(&bytes, path, strict, camera);
    }
    if let Some(what) = mesh::foreign(&bytes).filter(|_| !bytes.is_empty()) {
        return Err(refused(format!("{name}: {what}")));
    }
    if bytes.contains(&0) {
        return Err(refused(format!(
            "{name} is not text: it contains a zero byte"
        )));
    }
    if camera.is_some() {
        return Err(refused(format!(
            "{name} is not a glTF file: --camera selects a camera of glTF files only, the command `camera` sets that of a scene file"
        )));
    }
    // Old files have comments in Latin-1: they are not refused for bytes that are not UTF-8.
    parse(&String::from_utf8_lossy(&bytes), path, strict)
}

/// Reads the scene of a glTF file from its `bytes`, like [`read_seen`]; external buffers are relative to `path`.
///
/// # Errors
/// As [`read_seen`].
pub fn parse_model(
    bytes: &[u8],
    path: &Path,
    strict: bool,
    camera: Option<&str>,
) -> Result<Read, Errors> {
    model::read(bytes, path, strict, camera)
}

fn unreadable(path: &Path, reason: &io::Error) -> Errors {
    let message = format!("cannot read {}: {reason}", path.display());
    let mut log = Log::new(path, String::new());
    log.lacks_memory = reason.kind() == io::ErrorKind::OutOfMemory;
    log.fail(message)
}

/// Reads a scene from `text`; `path` gives the name in messages and the folder of meshes.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path, strict: bool) -> Result<Read, Errors> {
    let text = text::clean(text);
    let mut builder = builder::Builder::new(path, Log::new(path, text.clone()));
    for line in text::lines(&text) {
        commands::read_line(&mut builder, line);
    }
    builder.finish(text, strict)
}

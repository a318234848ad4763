//! Text → [`Scene`]: the course's scene format and the words that vkpt adds to it. Knows no buffers and no Vulkan.
//!
//! A file is read to its end whatever is wrong with it, so that all its errors are told in one go.
//! [`text`] cuts it into lines and tokens, [`commands`] has a row for each command, [`arguments`] takes
//! numbers off a line and checks them, and what is wrong becomes a [`Diagnostic`].

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

/// A scene and what its author should know.
#[derive(Clone, Debug)]
pub struct Read {
    pub scene: Scene,
    /// In file order.
    pub warnings: Vec<Diagnostic>,
    /// What was read, line by line.
    pub text: String,
}

/// A scene file longer than this, in bytes, is taken for something else.
const LONGEST_FILE: u64 = 256 << 20;

/// Reads a scene file and the meshes that it names.
///
/// # Errors
/// Everything that is wrong with the file, in file order, its warnings among them; with `strict` a warning is
/// an error too.
pub fn read(path: &Path, strict: bool) -> Result<Read, Errors> {
    match File::open(path) {
        Ok(file) => read_from(file, path, strict),
        Err(reason) => Err(unreadable(path, &reason)),
    }
}

/// Reads a scene from a stream; `path` is as for [`parse`].
///
/// # Errors
/// As [`read`].
pub fn read_from(source: impl io::Read, path: &Path, strict: bool) -> Result<Read, Errors> {
    let mut bytes = Vec::new();
    let name = path.display();
    let refused = |why: String| Log::new(path, String::new()).fail(why);
    let mut source = source.take(LONGEST_FILE + 1);
    source
        .read_to_end(&mut bytes)
        .map_err(|reason| unreadable(path, &reason))?;
    if bytes.len() as u64 > LONGEST_FILE {
        return Err(refused(format!(
            "{name} is longer than 256 MiB: this is no scene file"
        )));
    }
    if let Some(what) = mesh::foreign(&bytes).filter(|_| !bytes.is_empty()) {
        return Err(refused(format!("{name}: {what}")));
    }
    if bytes.contains(&0) {
        return Err(refused(format!("{name} is not text: it holds a zero byte")));
    }
    // Old files have comments in Latin-1: a byte that is not UTF-8 is no reason to refuse them.
    parse(&String::from_utf8_lossy(&bytes), path, strict)
}

fn unreadable(path: &Path, reason: &io::Error) -> Errors {
    let message = format!("cannot read {}: {reason}", path.display());
    Log::new(path, String::new()).fail(message)
}

/// Reads a scene from `text`; `path` gives the name in messages and the folder that meshes are looked for in.
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

//! Mesh files: which formats are read, and what may be wrong with one.

mod foreign;
pub(super) mod gltf;
mod left_out;
mod obj;
mod ply;
mod polygon;
mod positions;
mod text;

use std::io;
use std::path::{Path, PathBuf};

use glam::DVec3;

pub use foreign::foreign;

/// The formats that [`read_mesh`] reads, as messages name them.
pub const MESH_FORMATS: &str = "PLY (.ply), OBJ (.obj), glTF (.gltf, .glb)";

/// What a mesh file holds; in its own coordinates, at least one triangle, all numbers finite.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Files that it was read from besides its own.
    pub files: Vec<PathBuf>,
    pub positions: Vec<DVec3>,
    /// One a vertex, only where the file gives them: unit length, or zero where the file's has no direction.
    pub normals: Option<Vec<DVec3>>,
    /// Indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
    /// What the file asks for that is not done.
    pub warnings: Vec<String>,
}

/// What is wrong with a mesh file.
#[derive(Debug, thiserror::Error)]
pub enum MeshError {
    #[error("there is no such file")]
    Missing,
    #[error("takes {0} bytes of memory, and they are not there")]
    Memory(u64),
    #[error("is no file")]
    NoFile,
    #[error("cannot be read: {0}")]
    Unreadable(io::Error),
    #[error("its format is not read; these are: {MESH_FORMATS}")]
    Format,
    /// The bytes are not what the format asks for.
    #[error("{0}")]
    Malformed(String),
    #[error("element `{element}` is truncated: it claims {count}, and only {bytes} bytes follow")]
    Truncated {
        element: String,
        count: usize,
        bytes: usize,
    },
    #[error("vertex {0} (from 0) is not finite in single precision")]
    NotFinite(usize),
    #[error("face {face} (from 0) refers to vertex {index}, and there are {vertices}")]
    BadIndex {
        face: usize,
        index: i64,
        vertices: usize,
    },
    #[error("face {0} (from 0) crosses itself: cut it into triangles")]
    Crossing(usize),
    #[error("it has no {0}")]
    Empty(&'static str),
    #[error("it has no faces{}{}", if .0.is_empty() { "" } else { ": " }, .0.join(", "))]
    NoFaces(Vec<String>),
}

/// Reads a mesh; its ending tells the format.
///
/// # Errors
/// A [`MeshError`] for any file that is not a whole mesh; no file makes it panic, and none makes it take much
/// more memory than a few times the file's size.
pub fn read_mesh(path: &Path) -> Result<MeshFile, MeshError> {
    format(path)?;
    if path.is_dir() {
        return Err(MeshError::Unreadable(io::ErrorKind::IsADirectory.into()));
    }
    // A pipe may never begin, a device never end.
    if path.metadata().is_ok_and(|there| !there.is_file()) {
        return Err(MeshError::NoFile);
    }
    let bytes = std::fs::read(path).map_err(|reason| match reason.kind() {
        io::ErrorKind::NotFound => MeshError::Missing,
        io::ErrorKind::OutOfMemory => {
            MeshError::Memory(path.metadata().map_or(0, |there| there.len()))
        }
        _ => MeshError::Unreadable(reason),
    })?;
    parse_mesh(&bytes, path)
}

/// Reads the mesh that `bytes` hold, in the format that the ending of `path` tells; buffers of a glTF file are
/// looked for beside `path`. A byte order mark is skipped.
///
/// # Errors
/// As [`read_mesh`].
pub fn parse_mesh(bytes: &[u8], path: &Path) -> Result<MeshFile, MeshError> {
    let format = format(path)?;
    if let Some(what) = foreign(bytes) {
        return Err(MeshError::Malformed(what.into()));
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match format {
        Format::Ply => ply::read(bytes),
        Format::Obj => obj::read(bytes),
        Format::Gltf => gltf::read(bytes, path.parent().unwrap_or(Path::new(""))),
    }
}

/// Whether a file of this name would be read.
pub fn is_mesh_name(path: &Path) -> bool {
    format(path).is_ok()
}

/// A format that is read.
enum Format {
    Ply,
    Obj,
    Gltf,
}

/// The format that a file's ending tells.
fn format(path: &Path) -> Result<Format, MeshError> {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("ply") => Ok(Format::Ply),
        Some("obj") => Ok(Format::Obj),
        Some("gltf" | "glb") => Ok(Format::Gltf),
        _ => Err(MeshError::Format),
    }
}

/// Puts the corners of a face, which must be indices of vertices, in place of what `checked` has.
fn corners(
    face: usize,
    indices: &[i64],
    vertices: usize,
    checked: &mut Vec<u32>,
) -> Result<(), MeshError> {
    checked.clear();
    for &index in indices {
        match u32::try_from(index) {
            Ok(i) if (i as usize) < vertices => checked.push(i),
            _ => {
                return Err(MeshError::BadIndex {
                    face,
                    index,
                    vertices,
                });
            }
        }
    }
    Ok(())
}

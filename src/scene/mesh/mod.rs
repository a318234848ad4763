//! Mesh files: supported formats and errors.

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

/// The formats that [`read_mesh`] reads, as listed in messages.
pub const MESH_FORMATS: &str = "PLY (.ply), OBJ (.obj), glTF (.gltf, .glb)";

/// The content of a mesh file: in its own coordinates, at least one triangle, all numbers finite.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Further files that it was read from.
    pub files: Vec<PathBuf>,
    pub positions: Vec<DVec3>,
    /// One per vertex, only if the file gives them: unit length, or zero where the file's normal has no direction.
    pub normals: Option<Vec<DVec3>>,
    /// Indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
    /// Requests of the file that are not fulfilled.
    pub warnings: Vec<String>,
}

/// An error in a mesh file.
#[derive(Debug, thiserror::Error)]
pub enum MeshError {
    #[error("no such file")]
    Missing,
    #[error("takes {0} bytes of memory, which are not available")]
    Memory(u64),
    #[error("is not a regular file")]
    NoFile,
    #[error("cannot be read: {0}")]
    Unreadable(io::Error),
    #[error("unsupported format; the supported formats are {MESH_FORMATS}")]
    Format,
    /// The bytes violate the format.
    #[error("{0}")]
    Malformed(String),
    #[error("element `{element}` is truncated: it declares {count}, but only {bytes} bytes follow")]
    Truncated {
        element: String,
        count: usize,
        bytes: usize,
    },
    #[error("vertex {0} (from 0) is not finite in single precision")]
    NotFinite(usize),
    #[error("face {face} (from 0) refers to vertex {index}, but there are {vertices}")]
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

/// Reads a mesh; the file's extension determines the format.
///
/// # Errors
/// A [`MeshError`] for any file that is not a complete mesh. No file causes a panic, nor takes more memory than a few
/// times its size.
pub fn read_mesh(path: &Path) -> Result<MeshFile, MeshError> {
    format(path)?;
    if path.is_dir() {
        return Err(MeshError::Unreadable(io::ErrorKind::IsADirectory.into()));
    }
    // A pipe may never begin, a device may never end.
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

/// Reads a mesh from `bytes`, in the format given by the extension of `path`; external buffers of a glTF file are
/// relative to `path`. A byte order mark is skipped.
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

/// Whether a file with this name would be read.
pub fn is_mesh_name(path: &Path) -> bool {
    format(path).is_ok()
}

/// A supported format.
enum Format {
    Ply,
    Obj,
    Gltf,
}

/// The format given by a file's extension.
fn format(path: &Path) -> Result<Format, MeshError> {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("ply") => Ok(Format::Ply),
        Some("obj") => Ok(Format::Obj),
        Some("gltf" | "glb") => Ok(Format::Gltf),
        _ => Err(MeshError::Format),
    }
}

/// Replaces the content of `checked` by the corners of a face, which must be indices of vertices.
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

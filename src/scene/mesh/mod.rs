//! Mesh files: which formats are read, and what may be wrong with one.

mod gltf;
mod left_out;
mod obj;
mod ply;

use std::io;
use std::path::Path;

use glam::DVec3;

use super::text::quote;

/// The formats that [`read_mesh`] reads, as messages name them.
pub const MESH_FORMATS: &str = "PLY (.ply), OBJ (.obj), glTF (.gltf, .glb)";

/// What a mesh file holds; in its own coordinates, at least one triangle, all numbers finite.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
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
    #[error("face {face} (from 0) has {corners} corners")]
    NoPolygon { face: usize, corners: usize },
    #[error("it has no {0}")]
    Empty(&'static str),
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
    let bytes = std::fs::read(path).map_err(|reason| match reason.kind() {
        io::ErrorKind::NotFound => MeshError::Missing,
        _ => MeshError::Unreadable(reason),
    })?;
    parse_mesh(&bytes, path)
}

/// Reads the mesh that `bytes` hold, in the format that the ending of `path` tells; buffers of a glTF file are
/// looked for beside `path`.
///
/// # Errors
/// As [`read_mesh`].
pub fn parse_mesh(bytes: &[u8], path: &Path) -> Result<MeshFile, MeshError> {
    match format(path)? {
        Format::Ply => ply::read(bytes),
        Format::Obj => obj::read(bytes),
        Format::Gltf => gltf::read(bytes, path.parent().unwrap_or(Path::new(""))),
    }
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

/// The corners of a polygon, as indices of vertices that there are.
fn polygon(face: usize, corners: &[i64], vertices: usize) -> Result<Vec<u32>, MeshError> {
    let index = |&index: &i64| match u32::try_from(index) {
        Ok(i) if (i as usize) < vertices => Ok(i),
        _ => Err(MeshError::BadIndex {
            face,
            index,
            vertices,
        }),
    };
    let checked = corners.iter().map(index).collect::<Result<Vec<_>, _>>()?;
    match checked.len() {
        corners @ 0..3 => Err(MeshError::NoPolygon { face, corners }),
        _ => Ok(checked),
    }
}

/// Appends the triangles of a polygon of three corners or more: a fan about its first corner.
fn fan(triangles: &mut Vec<[u32; 3]>, corners: &[u32]) {
    let pairs = corners[1..].windows(2);
    triangles.extend(pairs.map(|pair| [corners[0], pair[0], pair[1]]));
}

/// What is wrong with line `number` (from 1) of the text `bytes`, which is quoted.
fn at_line(bytes: &[u8], number: usize, what: &str) -> MeshError {
    let line = bytes
        .split(|b| *b == b'\n')
        .nth(number.saturating_sub(1))
        .unwrap_or_default();
    let quoted = quote(&String::from_utf8_lossy(line));
    MeshError::Malformed(format!("its line {number} {what}: `{quoted}`"))
}

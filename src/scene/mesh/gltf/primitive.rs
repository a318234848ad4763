//! A primitive of a mesh: its vertices and triangles, in the mesh's own space.

use glam::DVec3;
use gltf::Semantic;
use gltf::json::mesh::{Mode, Primitive};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index, Node, Root};

use super::accessors::Accessors;

/// The triangles of a primitive.
pub(super) struct Triangles {
    pub(super) positions: Vec<DVec3>,
    /// As many as positions.
    pub(super) normals: Option<Vec<DVec3>>,
    /// Indices of positions.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// Reads a primitive; `None` if it consists of points or lines. An error says what is wrong.
pub(super) fn read(
    primitive: &Primitive,
    accessors: &Accessors,
) -> Result<Option<Triangles>, String> {
    let mode = match primitive.mode {
        Checked::Valid(Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) => {
            return Ok(None);
        }
        Checked::Valid(mode) => mode,
        Checked::Invalid => return Err("its mode is not known".into()),
    };
    let attribute = |name| primitive.attributes.get(&Checked::Valid(name)).copied();
    let positions = attribute(Semantic::Positions).ok_or("it has no positions")?;
    let positions = accessors.vectors(positions)?;
    let normals = attribute(Semantic::Normals).map(|normals| accessors.vectors(normals));
    let normals = normals.transpose()?;
    let (vertices, given) = (positions.len(), normals.as_ref().map(Vec::len));
    if let Some(given) = given.filter(|given| *given != vertices) {
        return Err(format!("it has {given} normals for {vertices} vertices"));
    }
    let indices = match primitive.indices {
        Some(indices) => accessors.indices(indices)?,
        None => (0..vertices as u32).collect(),
    };
    if let Some(bad) = indices.iter().find(|i| **i as usize >= vertices) {
        return Err(format!(
            "it refers to vertex {bad}, and there are {vertices}"
        ));
    }
    let triangles = triangles(mode, &indices)?;
    Ok(Some(Triangles {
        positions,
        normals,
        triangles,
    }))
}

/// How many vertices or corners, whichever are more, a node's mesh asks for.
pub(super) fn asked(node: &Node, root: &Root) -> u64 {
    let mesh = node.mesh.and_then(|mesh| root.get(mesh));
    let primitives = mesh.iter().flat_map(|mesh| &mesh.primitives);
    let count = |i: Index<Accessor>| root.get(i).map_or(0, |accessor| accessor.count.0);
    primitives
        .map(|primitive| {
            let vertices = primitive.attributes.values().map(|a| count(*a));
            vertices
                .chain(primitive.indices.map(count))
                .max()
                .unwrap_or(0)
        })
        .fold(0, u64::saturating_add)
}

/// The triangles of a list, a strip or a fan (glTF 2.0, section 3.7.2.1); those that repeat a corner only join a strip.
fn triangles(mode: Mode, indices: &[u32]) -> Result<Vec<[u32; 3]>, String> {
    let windows = indices.windows(3);
    let triangles: Vec<[u32; 3]> = match mode {
        Mode::TriangleStrip => windows
            .enumerate()
            // pᵢ = (vᵢ, vᵢ₊₁₊ᵢ mod ₂, vᵢ₊₂₋ᵢ mod ₂)
            .map(|(i, v)| [v[0], v[1 + i % 2], v[2 - i % 2]])
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect(),
        // pᵢ = (vᵢ₊₁, vᵢ₊₂, v₀)
        Mode::TriangleFan => indices
            .windows(2)
            .skip(1)
            .map(|v| [v[0], v[1], indices[0]])
            .collect(),
        _ if !indices.len().is_multiple_of(3) => {
            return Err(format!("{} corners make no triangles", indices.len()));
        }
        _ => indices
            .chunks_exact(3)
            .map(|v| [v[0], v[1], v[2]])
            .collect(),
    };
    Ok(triangles)
}

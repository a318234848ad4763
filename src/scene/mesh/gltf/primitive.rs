//! A primitive of a mesh: its vertices and triangles, in the mesh's own space.

use glam::DVec3;

use super::super::left_out::LeftOut;
use super::accessors::Accessors;
use super::document::{Document, Node, Primitive};
use super::requirements::or_compressed;
use super::topology::Mode;

/// The triangles of a primitive.
pub(super) struct Triangles {
    pub(super) positions: Vec<DVec3>,
    /// One per position: of unit length, or zero.
    pub(super) normals: Option<Vec<DVec3>>,
    /// Indices of positions.
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Primitive {
    fn mode(&self) -> Result<Option<Mode>, String> {
        Mode::of(self.mode.unwrap_or(4))
    }

    /// Consists of triangles, or of an unknown mode, which must be reported.
    pub(super) fn has_triangles(&self) -> bool {
        !matches!(self.mode(), Ok(None))
    }
}

/// Reads a primitive; `None` if it consists of points or lines. Errors are messages.
pub(super) fn read(
    primitive: &Primitive,
    accessors: &Accessors,
    left_out: &mut LeftOut,
) -> Result<Option<Triangles>, String> {
    match primitive.mode()? {
        Some(mode) => triangles(primitive, mode, accessors, left_out)
            .map(Some)
            .map_err(|what| or_compressed(what, &primitive.extensions)),
        None => Ok(None),
    }
}

fn triangles(
    primitive: &Primitive,
    mode: Mode,
    accessors: &Accessors,
    left_out: &mut LeftOut,
) -> Result<Triangles, String> {
    let vectors = |accessor: usize| -> Result<Vec<DVec3>, String> {
        let vectors = accessors.vectors(accessor)?;
        Ok(vectors.into_iter().map(DVec3::from_array).collect())
    };
    let attribute = |name| primitive.attributes.get(name).copied();
    let positions = vectors(attribute("POSITION").ok_or("it has no positions")?)?;
    let normals = attribute("NORMAL").map(vectors).transpose()?;
    let (vertices, given) = (positions.len(), normals.as_ref().map(Vec::len));
    if let Some(given) = given.filter(|given| *given != vertices) {
        return Err(format!("it has {given} normals for {vertices} vertices"));
    }
    let corners = match primitive.indices {
        Some(indices) => corners(indices, mode, vertices, accessors)?,
        None => (0..vertices as u32).collect(),
    };
    let triangles = mode.triangles(&corners, left_out);
    let normals = normals.map(|normals| left_out.directions(normals.into_iter(), &triangles));
    Ok(Triangles {
        positions,
        normals,
        triangles,
    })
}

/// The indices of an accessor, checked.
fn corners(
    accessor: usize,
    mode: Mode,
    vertices: usize,
    accessors: &Accessors,
) -> Result<Vec<u32>, String> {
    let indices = accessors.indices::<1>(accessor)?.into_flattened();
    // A list cannot restart: there such an index is an ordinary vertex or out of range.
    let restart = accessors.no_index(accessor).filter(|_| mode != Mode::List);
    if let Some(restart) = restart.filter(|restart| indices.contains(restart)) {
        return Err(format!(
            "its index {restart} restarts a strip, which glTF 2.0 forbids: export it as a list of triangles"
        ));
    }
    match indices.iter().find(|i| **i as usize >= vertices) {
        Some(bad) => Err(format!(
            "it refers to vertex {bad}, but there are {vertices}"
        )),
        None => Ok(indices),
    }
}

/// The size of a node's mesh: vertices or corners, the larger number, times the number of joints per vertex; plus the
/// joints of its skin.
pub(super) fn asked(node: &Node, document: &Document) -> u64 {
    let mesh = node.mesh.and_then(|mesh| document.meshes.get(mesh));
    let primitives = mesh.iter().flat_map(|mesh| &mesh.primitives);
    let count = |accessor: &usize| document.accessors.get(*accessor).map_or(0, |a| a.count);
    let of_primitive = |primitive: &Primitive| {
        let names = primitive.attributes.keys();
        let sets = names.filter(|name| name.starts_with("JOINTS_")).count() as u64;
        let accessors = primitive.attributes.values().chain(&primitive.indices);
        let most = accessors.map(count).max().unwrap_or(0);
        most.saturating_mul(sets.max(1))
    };
    let skin = node.skin.and_then(|skin| document.skins.get(skin));
    let joints = skin.map_or(0, |skin| skin.joints.len() as u64);
    primitives
        .map(of_primitive)
        .fold(joints, u64::saturating_add)
}

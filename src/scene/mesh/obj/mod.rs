//! OBJ (Wavefront, *Object Files*, Advanced Visualizer manual, appendix B1): `v`, `vn` and `f`, over `tobj`.
//!
//! All faces of a file are one mesh, whatever objects, groups and materials they stand in. A face has normals if
//! each of its corners names one; the others are flat. Points, lines, curves, colours and textures are skipped.

mod statements;

use std::collections::HashMap;

use glam::DVec3;
use tobj::LoadOptions;

use super::{MeshError, MeshFile, at_line, fan};
use statements::Statements;

/// Reads the whole file `bytes`.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    let mut statements = Statements::new(bytes);
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let loaded = tobj::load_obj_buf(&mut statements, &LoadOptions::default(), no_materials);
    let Ok((models, _)) = loaded else {
        let (line, what) = statements.culprit();
        return Err(at_line(bytes, line, &what));
    };
    // Without objects, groups and materials there is one model.
    let mesh = models.into_iter().next().map(|model| model.mesh);
    assemble(&mesh.unwrap_or_default(), &statements, bytes)
}

/// The crate's mesh, which has an index for positions and one for normals, in the scene's form, which has one.
fn assemble(
    mesh: &tobj::Mesh,
    statements: &Statements,
    bytes: &[u8],
) -> Result<MeshFile, MeshError> {
    let mut vertices = Vertices::default();
    let mut triangles = Vec::with_capacity(mesh.indices.len() / 3);
    let mut first = 0;
    for (i, face) in statements.faces.iter().enumerate() {
        // No arities: all are triangles.
        let end = first + mesh.face_arities.get(i).map_or(3, |n| *n as usize);
        let corner = |k: usize| {
            let normal = face.smooth.then(|| mesh.normal_indices[k]);
            vertices.index(mesh, mesh.indices[k], normal)
        };
        let corners: Option<Vec<u32>> = (first..end).map(corner).collect();
        let what = "has a vertex that is not finite in single precision";
        fan(
            &mut triangles,
            &corners.ok_or_else(|| at_line(bytes, face.line, what))?,
        );
        first = end;
    }
    if triangles.is_empty() {
        return Err(MeshError::Empty("faces"));
    }
    let smooth = statements.faces.iter().any(|face| face.smooth);
    Ok(MeshFile {
        positions: vertices.positions,
        normals: smooth.then_some(vertices.normals),
        triangles,
        warnings: Vec::new(),
    })
}

/// The pairs of position and normal that occur.
#[derive(Default)]
struct Vertices {
    known: HashMap<(u32, Option<u32>), u32>,
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
}

impl Vertices {
    /// The vertex at a position of the mesh, with one of its normals or flat; `None` where it is not finite.
    fn index(&mut self, mesh: &tobj::Mesh, position: u32, normal: Option<u32>) -> Option<u32> {
        if let Some(known) = self.known.get(&(position, normal)) {
            return Some(*known);
        }
        let triple = |all: &[f64], i: u32| DVec3::from_slice(&all[3 * i as usize..]);
        let p = triple(&mesh.positions, position);
        let n = normal.map_or(DVec3::ZERO, |normal| triple(&mesh.normals, normal));
        if !(p.as_vec3().is_finite() && n.as_vec3().is_finite()) {
            return None;
        }
        let fresh = self.positions.len() as u32;
        self.positions.push(p);
        self.normals.push(n.normalize_or_zero());
        self.known.insert((position, normal), fresh);
        Some(fresh)
    }
}

//! OBJ (Wavefront, *Object Files*, Advanced Visualizer manual, appendix B1): `v`, `vn` and `f`.
//!
//! All faces of a file form one mesh, across objects, groups and materials. A face has normals if each of its corners
//! names an existing one; other faces are flat. Points, lines, colours and textures are skipped; curves, surfaces and
//! unknown words are counted for a warning.

mod lines;
mod statements;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use glam::DVec3;

use super::left_out::unit_or_zero;
use super::polygon::{CROSSES, Crossing, cut};
use super::text::at_line;
use super::{MeshError, MeshFile};
use statements::{Corner, Statements};

/// Reads the complete file `bytes`.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    let mut statements = Statements::default();
    for (number, line) in lines::statements(bytes) {
        let read = statements.read(number, &line);
        read.map_err(|what| at_line(bytes, number, &what))?;
    }
    let checked = statements.check_highest();
    checked.map_err(|(line, what)| at_line(bytes, line, &what))?;
    assemble(&statements, bytes)
}

/// Converts the file's mesh, which indexes positions and normals separately, to the scene's form with one index.
fn assemble(statements: &Statements, bytes: &[u8]) -> Result<MeshFile, MeshError> {
    let mut vertices = Vertices::of(statements);
    let mut left_out = statements.left_out.clone();
    let mut triangles = Vec::with_capacity(statements.faces.len());
    let mut corners = Vec::new();
    let (mut first, mut any_smooth) = (0, false);
    for face in &statements.faces {
        corners.clear();
        let of_face = &statements.corners[first..face.end];
        first = face.end;
        let missing = if face.smooth {
            statements.without_normal(of_face)
        } else {
            0
        };
        left_out.references += missing;
        let smooth = face.smooth && missing == 0;
        any_smooth |= smooth;
        for corner in of_face {
            let index = vertices.index(corner, smooth);
            let what = "has a vertex that is not finite in single precision";
            corners.push(index.ok_or_else(|| at_line(bytes, face.line, what))?);
        }
        let cut = cut(&corners, |i| vertices.positions[i as usize], &mut triangles);
        cut.map_err(|Crossing| at_line(bytes, face.line, CROSSES))?;
    }
    if triangles.is_empty() {
        return Err(MeshError::NoFaces(left_out.warnings()));
    }
    left_out.normals = vertices.without_direction.len();
    let warnings = left_out.warnings();
    Ok(MeshFile {
        files: Vec::new(),
        positions: vertices.positions,
        normals: any_smooth.then_some(vertices.normals),
        triangles,
        warnings,
    })
}

/// A vertex that does not exist yet.
const NONE: u32 = u32::MAX;

/// The pairs of position and normal in use.
struct Vertices<'a> {
    statements: &'a Statements,
    /// The flat vertex at each position; the other field has the vertices with a normal.
    flat: Vec<u32>,
    smooth: HashMap<(u32, u32), u32>,
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Normals of the file without a direction.
    without_direction: HashSet<u32>,
}

impl<'a> Vertices<'a> {
    fn of(statements: &'a Statements) -> Self {
        Self {
            statements,
            flat: vec![NONE; statements.positions.len()],
            smooth: HashMap::new(),
            positions: Vec::new(),
            normals: Vec::new(),
            without_direction: HashSet::new(),
        }
    }

    /// The vertex at a corner, with its normal or flat; `None` if it is not finite.
    fn index(&mut self, corner: &Corner, smooth: bool) -> Option<u32> {
        let position = corner.position as usize;
        let known = match smooth {
            true => self
                .smooth
                .entry((corner.position, corner.normal))
                .or_insert(NONE),
            false => &mut self.flat[position],
        };
        if *known == NONE {
            let p = self.statements.positions[position];
            if !p.as_vec3().is_finite() {
                return None;
            }
            *known = self.positions.len() as u32;
            self.positions.push(p);
            let normal = match smooth {
                true => unit_or_zero(self.statements.normals[corner.normal as usize]),
                false => DVec3::ZERO,
            };
            if smooth && normal == DVec3::ZERO {
                self.without_direction.insert(corner.normal);
            }
            self.normals.push(normal);
        }
        Some(*known)
    }
}

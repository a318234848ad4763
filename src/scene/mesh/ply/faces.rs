//! The triangles of a PLY file's faces and strips.

use super::element::{Lists, Rows};
use crate::scene::MeshError;
use crate::scene::mesh::corners;
use crate::scene::mesh::left_out::LeftOut;
use crate::scene::mesh::polygon::{CROSSES, Crossing, cut};
use crate::scene::mesh::text::at_line;

/// The triangles of the faces.
pub(super) fn polygons(
    rows: &Rows,
    triangles: &mut Vec<[u32; 3]>,
    left_out: &mut LeftOut,
    file: &[u8],
) -> Result<(), MeshError> {
    let mut first = 0;
    let mut polygon = Vec::new();
    for (index, row) in rows.faces.rows.iter().enumerate() {
        corners(
            index,
            &rows.faces.corners[first..row.end],
            rows.positions.len(),
            &mut polygon,
        )?;
        first = row.end;
        if polygon.len() < 3 {
            left_out.faces += 1;
            continue;
        }
        let bad = polygon
            .iter()
            .find(|i| !rows.positions[**i as usize].as_vec3().is_finite());
        if let Some(bad) = bad {
            return Err(MeshError::NotFinite(*bad as usize));
        }
        let cut = cut(&polygon, |i| rows.positions[i as usize], triangles);
        cut.map_err(|Crossing| match row.line {
            0 => MeshError::Crossing(index),
            line => at_line(file, line, CROSSES),
        })?;
    }
    Ok(())
}

/// The triangles of strips: (v₀, v₁, v₂), (v₂, v₁, v₃), …, except those that repeat a corner, which only join two
/// strips.
pub(super) fn strips(
    strips: &Lists,
    vertices: usize,
    triangles: &mut Vec<[u32; 3]>,
    left_out: &mut LeftOut,
) -> Result<(), MeshError> {
    let mut strip = Vec::new();
    let mut first = 0;
    for (index, row) in strips.rows.iter().enumerate() {
        for part in strips.corners[first..row.end].split(|corner| *corner == -1) {
            corners(index, part, vertices, &mut strip)?;
            left_out.faces += usize::from(matches!(strip.len(), 1..3));
            let wound = strip.windows(3).enumerate().map(|(i, v)| match i % 2 {
                0 => [v[0], v[1], v[2]],
                _ => [v[1], v[0], v[2]],
            });
            triangles.extend(wound.filter(|[a, b, c]| a != b && b != c && c != a));
        }
        first = row.end;
    }
    Ok(())
}

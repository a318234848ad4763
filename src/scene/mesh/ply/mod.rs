//! PLY (Turk, *The PLY Polygon File Format*, 1994), ASCII and both binary byte orders: vertices, faces and triangle
//! strips.
//!
//! An ASCII body is a stream of numbers regardless of line ends, as in other readers. The counts of a header are
//! checked against the number of bytes present before they are used.

mod declared;
mod element;
mod faces;
mod header;
mod source;

use declared::{Element, Encoding, Kind, Property};
use element::{CORNERS, Rows};
use faces::{polygons, strips};
use header::Header;
use source::{Binary, Fault, Source, Text};

use super::left_out::LeftOut;
use super::positions::finite;
use super::text::{Tokens, at_line, lines};
use super::{MeshError, MeshFile};

/// Reads the complete file `bytes`.
///
/// Messages quote the file's own lines.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    let header = header::read(bytes)?;
    check_names(&header)?;
    let body = &bytes[header.length..];
    let rows = match header.encoding {
        Encoding::Ascii => {
            let mut text = Text(Tokens::new(body, header.lines + 1));
            let rows = read_body(&mut text, &header, bytes)?;
            match text.0.next() {
                Some(_) => return Err(too_many(&header, text.0.line(), bytes)),
                None => rows,
            }
        }
        encoding => {
            let big_endian = encoding == Encoding::BigEndian;
            let mut binary = Binary {
                rest: body,
                big_endian,
            };
            read_body(&mut binary, &header, bytes)?
        }
    };
    assemble(rows, has_numbers(&header, ["nx", "ny", "nz"]), bytes)
}

/// An error if the vertices have no position or the faces no corners.
fn check_names(header: &Header) -> Result<(), MeshError> {
    if !has_numbers(header, ["x", "y", "z"]) {
        return Err(MeshError::Empty("element `vertex` with properties x, y, z"));
    }
    let has_corners = |element: &Element| {
        element.properties.iter().any(|property| {
            CORNERS.contains(&&*property.name)
                && matches!(property.kind, Kind::List { of, .. } if of.is_integer())
        })
    };
    let mut polygons = header
        .elements
        .iter()
        .filter(|e| ["face", "tristrips"].contains(&&*e.name));
    match polygons.any(has_corners) {
        true => Ok(()),
        false => Err(MeshError::Empty(
            "element `face` with a list of integers, vertex_index or vertex_indices",
        )),
    }
}

/// Whether the vertices have a number of each of these names.
fn has_numbers(header: &Header, names: [&str; 3]) -> bool {
    let vertex = header
        .elements
        .iter()
        .find(|element| element.name == "vertex");
    let of = |vertex: &Element, name: &str| {
        let mut properties = vertex.properties.iter();
        properties.any(|p| p.name == name && matches!(p.kind, Kind::Scalar(_)))
    };
    vertex.is_some_and(|vertex| names.iter().all(|name| of(vertex, name)))
}

/// The rows of all elements.
fn read_body(source: &mut impl Source, header: &Header, file: &[u8]) -> Result<Rows, MeshError> {
    let mut rows = Rows::default();
    for element in header
        .elements
        .iter()
        .filter(|element| !element.properties.is_empty())
    {
        let bytes = source.bytes_left();
        let all = element
            .count
            .checked_mul(element.least_size(header.encoding));
        if all.is_none_or(|all| all > bytes.saturating_add(1)) {
            let (element, count) = (element.name.clone(), element.count);
            return Err(MeshError::Truncated {
                element,
                count,
                bytes,
            });
        }
        rows.read(source, element).map_err(|fault| match fault {
            Fault::Line(0) => MeshError::Malformed(format!(
                "row {} (from 0) of its element `{}` has a list of negative length",
                rows.read, element.name
            )),
            Fault::Line(line) => at_line(file, line, "cannot be read"),
            Fault::End => MeshError::Malformed(format!(
                "it ends in row {} of the {} of its element `{}`",
                rows.read + 1,
                element.count,
                element.name
            )),
        })?;
    }
    Ok(rows)
}

/// An error: from line `left` on, there are more numbers than the header declares. It reports the first row on its own
/// line with more numbers than its scalars, if there is one, because the surplus numbers at the end are others.
fn too_many(header: &Header, left: usize, file: &[u8]) -> MeshError {
    let mut rows = (1..).zip(lines(file)).skip(header.lines);
    let of_scalars = |element: &&Element| {
        let is_scalar = |property: &Property| matches!(property.kind, Kind::Scalar(_));
        element.properties.iter().all(is_scalar)
    };
    for element in header.elements.iter().take_while(of_scalars) {
        for (number, line) in rows.by_ref().take(element.count) {
            if Tokens::new(line, number).count() > element.properties.len() {
                let declared = element.properties.len();
                return at_line(
                    file,
                    number,
                    &format!("has more than the {declared} numbers that its header declares"),
                );
            }
        }
    }
    at_line(file, left, "is more than its header declares")
}

/// Vertices and faces, checked and converted to the scene's form.
fn assemble(rows: Rows, with_normals: bool, file: &[u8]) -> Result<MeshFile, MeshError> {
    let mut left_out = LeftOut::default();
    let mut triangles = Vec::with_capacity(rows.faces.rows.len());
    polygons(&rows, &mut triangles, &mut left_out, file)?;
    strips(
        &rows.strips,
        rows.positions.len(),
        &mut triangles,
        &mut left_out,
    )?;
    if triangles.is_empty() {
        return Err(MeshError::NoFaces(left_out.warnings()));
    }
    let positions = finite(rows.positions, &triangles).map_err(MeshError::NotFinite)?;
    let normals = with_normals.then(|| left_out.directions(rows.normals.into_iter(), &triangles));
    Ok(MeshFile {
        files: Vec::new(),
        positions,
        normals,
        triangles,
        warnings: left_out.warnings(),
    })
}

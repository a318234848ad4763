//! PLY (Turk, *The PLY Polygon File Format*, 1994), ASCII and both binary byte orders, over `ply-rs-bw`.
//!
//! That crate trusts a header's counts; here each is held against the bytes that are there before it is used.

mod ascii;
mod element;
mod header;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, PropertyAccess};

use element::{Face, Other, Vertex};
use header::{check_names, has, least_size};

use super::left_out::LeftOut;
use super::{MeshError, MeshFile, at_line, fan, polygon};

/// Reads the whole file `bytes`.
///
/// Messages quote the file's own lines.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    let text = ascii::with_digits(bytes);
    let mut reader = Reader::new(&*text);
    let header = Parser::<Other>::new()
        .read_header(&mut reader)
        .map_err(|error| malformed(error, bytes))?;
    check_names(&header, &text[..text.len() - reader.get_ref().len()])?;
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => vertices = payload::<Vertex>(&mut reader, element, &header, bytes)?,
            "face" => faces = payload::<Face>(&mut reader, element, &header, bytes)?,
            _ => drop(payload::<Other>(&mut reader, element, &header, bytes)?),
        }
    }
    let with_normals = header
        .elements
        .get("vertex")
        .is_some_and(|vertex| has(vertex, ["nx", "ny", "nz"]));
    assemble(&vertices, &faces, with_normals)
}

/// Vertices and faces, checked and put into the scene's form.
fn assemble(
    vertices: &[Vertex],
    faces: &[Face],
    with_normals: bool,
) -> Result<MeshFile, MeshError> {
    let finite = |v: &Vertex| v.position.as_vec3().is_finite();
    if let Some(bad) = vertices.iter().position(|v| !finite(v)) {
        return Err(MeshError::NotFinite(bad));
    }
    let mut triangles = Vec::with_capacity(faces.len());
    for (index, face) in faces.iter().enumerate() {
        fan(
            &mut triangles,
            &polygon(index, &face.corners, vertices.len())?,
        );
    }
    if triangles.is_empty() {
        return Err(MeshError::Empty("faces"));
    }
    let mut left_out = LeftOut::default();
    let normals =
        with_normals.then(|| left_out.directions(vertices.iter().map(|v| v.normal), &triangles));
    Ok(MeshFile {
        positions: vertices.iter().map(|v| v.position).collect(),
        normals,
        triangles,
        warnings: left_out.warnings(),
    })
}

/// The payload of one element, which comes next in `file`.
fn payload<E: PropertyAccess>(
    reader: &mut Reader<&[u8]>,
    element: &ElementDef,
    header: &Header,
    file: &[u8],
) -> Result<Vec<E>, MeshError> {
    let bytes = reader.get_ref().len();
    let least = least_size(element, header.encoding);
    if least == 0 {
        return Ok(Vec::new());
    }
    if element
        .count
        .checked_mul(least)
        .is_none_or(|all| all > bytes.saturating_add(1))
    {
        return Err(MeshError::Truncated {
            element: element.name.clone(),
            count: element.count,
            bytes,
        });
    }
    Parser::<E>::new()
        .read_payload_for_element(reader, element, header)
        .map_err(|error| malformed(error, file))
}

/// What the crate says of `bytes`, on one line and without the grammar that it expected.
fn malformed(error: ParseError, bytes: &[u8]) -> MeshError {
    let message = error.to_string();
    let first = message.lines().next().unwrap_or_default();
    // Its errors of a line of text quote that line.
    match error.line().filter(|_| message.contains("String: '")) {
        Some(line) => at_line(bytes, line, "is not understood"),
        // Of a binary file it counts elements as lines.
        None => MeshError::Malformed(
            first
                .trim_start_matches("Line ")
                .trim_start_matches(|c: char| c.is_ascii_digit() || ": ".contains(c))
                .to_owned(),
        ),
    }
}

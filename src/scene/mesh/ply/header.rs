//! What a PLY file's header must declare, and how many bytes that takes.

use ply_rs_bw::ply::{ElementDef, Encoding, Header, PropertyType, ScalarType};

use super::element::CORNERS;
use crate::scene::MeshError;

/// An error where a name stands twice in the header (the crate would drop one of the two and misread the
/// rest), or where the vertices have no position or the faces no corners.
pub(super) fn check_names(header: &Header, text: &[u8]) -> Result<(), MeshError> {
    let declared = |word: &[u8]| {
        text.split(|b| *b == b'\n')
            .filter(|line| line.starts_with(word))
            .count()
    };
    let properties: usize = header
        .elements
        .values()
        .map(|element| element.properties.len())
        .sum();
    if declared(b"element") != header.elements.len() || declared(b"property") != properties {
        return Err(MeshError::Malformed(
            "a name stands twice in its header".into(),
        ));
    }
    match header.elements.get("vertex") {
        Some(vertex) if has(vertex, ["x", "y", "z"]) => (),
        _ => return Err(MeshError::Empty("element `vertex` with properties x, y, z")),
    }
    let corners = |face: &ElementDef| {
        face.properties.iter().any(|(name, p)| {
            CORNERS.contains(&name.as_str())
                && matches!(p.data_type, PropertyType::List(_, ref of) if is_integer(of))
        })
    };
    match header.elements.get("face").is_some_and(corners) {
        true => Ok(()),
        false => Err(MeshError::Empty(
            "element `face` with a list of integers, vertex_index or vertex_indices",
        )),
    }
}

pub(super) fn has(element: &ElementDef, names: [&str; 3]) -> bool {
    let scalar = |p: &PropertyType| matches!(p, PropertyType::Scalar(_));
    names.iter().all(|name| {
        element
            .properties
            .get(*name)
            .is_some_and(|p| scalar(&p.data_type))
    })
}

fn is_integer(scalar: &ScalarType) -> bool {
    !matches!(scalar, ScalarType::Float | ScalarType::Double)
}

/// The least number of bytes that one element of this kind takes. In ASCII the file's last line may lack one.
pub(super) fn least_size(element: &ElementDef, encoding: Encoding) -> usize {
    let size = |scalar: &ScalarType| match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    };
    match encoding {
        // A digit each, and a blank or the line's end after it.
        Encoding::Ascii => (2 * element.properties.len()).max(1),
        Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => element
            .properties
            .values()
            .map(|p| match &p.data_type {
                PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => size(scalar),
            })
            .sum(),
    }
}

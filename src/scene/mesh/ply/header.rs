//! The header of a PLY file, line by line.

use std::str;

use super::declared::{Element, Encoding, Kind, Property, Scalar};
use crate::scene::MeshError;
use crate::scene::mesh::text::{at_line, lines};

pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Its length in bytes, including the end of its last line, and in lines.
    pub(super) length: usize,
    pub(super) lines: usize,
}

/// Reads the header of the file `bytes`. Comments may have any encoding.
pub(super) fn read(bytes: &[u8]) -> Result<Header, MeshError> {
    let mut all = (1..).zip(lines(bytes));
    let (_, first) = all.next().unwrap_or_default();
    if first.trim_ascii() != b"ply" {
        return Err(at_line(bytes, 1, NOT_UNDERSTOOD));
    }
    // A binary body may begin with a byte that looks like the second half of a line end.
    let is_bare_cr =
        bytes[first.len()..].starts_with(b"\r") && !bytes[first.len()..].starts_with(b"\r\n");
    let (mut encoding, mut elements) = (None, Vec::new());
    for (number, line) in all {
        let end = line.as_ptr() as usize - bytes.as_ptr() as usize + line.len();
        let text = str::from_utf8(line).unwrap_or_default();
        let words: Vec<&str> = text.split_whitespace().collect();
        let read = match words[..] {
            ["end_header"] => {
                let ending = match &bytes[end..] {
                    [b'\r', b'\n', ..] if !is_bare_cr => 2,
                    rest => rest.len().min(1),
                };
                return Ok(Header {
                    encoding: encoding.ok_or(MeshError::Empty("line `format` in its header"))?,
                    elements,
                    length: end + ending,
                    lines: number,
                });
            }
            ["format", format, "1.0"] => {
                encoding = encoding_of(format);
                encoding.map(drop).ok_or(NOT_UNDERSTOOD)
            }
            ["element", name, count] => element(&mut elements, name, count),
            ["property", ref words @ ..] => property(&mut elements, words),
            _ if is_comment(line) => Ok(()),
            _ => Err(NOT_UNDERSTOOD),
        };
        read.map_err(|fault| at_line(bytes, number, fault))?;
    }
    Err(MeshError::Malformed("its header does not end".into()))
}

fn encoding_of(format: &str) -> Option<Encoding> {
    match format {
        "ascii" => Some(Encoding::Ascii),
        "binary_little_endian" => Some(Encoding::LittleEndian),
        "binary_big_endian" => Some(Encoding::BigEndian),
        _ => None,
    }
}

/// A comment may be in Latin-1; blank lines count as comments.
fn is_comment(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    line.is_empty()
        || [&b"comment"[..], b"obj_info"]
            .iter()
            .any(|word| line.starts_with(word))
}

/// An error message about a line.
type Fault = &'static str;

const NOT_UNDERSTOOD: Fault = "cannot be read";

/// `element NAME COUNT`
fn element(elements: &mut Vec<Element>, name: &str, count: &str) -> Result<(), Fault> {
    unique(elements.iter().map(|element| &*element.name), name)?;
    elements.push(Element {
        name: name.into(),
        count: count.parse().map_err(|_| NOT_UNDERSTOOD)?,
        properties: Vec::new(),
    });
    Ok(())
}

/// The words after `property`: `TYPE NAME` or `list TYPE TYPE NAME`.
fn property(elements: &mut [Element], words: &[&str]) -> Result<(), Fault> {
    let kind = match *words {
        ["list", count, of, _] => match (Scalar::of(count), Scalar::of(of)) {
            (Some(count), Some(of)) if count.is_integer() => Some(Kind::List { count, of }),
            _ => None,
        },
        [scalar, _] => Scalar::of(scalar).map(Kind::Scalar),
        _ => None,
    };
    let (Some(kind), Some(name), Some(element)) = (kind, words.last(), elements.last_mut()) else {
        return Err(NOT_UNDERSTOOD);
    };
    let names = element.properties.iter().map(|property| &*property.name);
    unique(names, name)?;
    let name = (*name).into();
    element.properties.push(Property { name, kind });
    Ok(())
}

/// Refuses repeated names, which are ambiguous.
fn unique<'a>(mut names: impl Iterator<Item = &'a str>, name: &str) -> Result<(), Fault> {
    match names.any(|other| other == name) {
        true => Err("repeats an earlier name"),
        false => Ok(()),
    }
}

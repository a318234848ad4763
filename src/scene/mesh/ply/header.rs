//! What a PLY file's header declares.

use std::str;

use crate::scene::MeshError;
use crate::scene::mesh::text::{at_line, lines};

/// How the numbers of the body are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Both of a type's names.
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// What a property has in each row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    /// A count, and so many numbers.
    List {
        count: Scalar,
        of: Scalar,
    },
}

#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// The least number of bytes that a row takes. In ASCII the file's last line may lack one.
    pub(super) fn least_size(&self, encoding: Encoding) -> usize {
        let size = |property: &Property| match (encoding, property.kind) {
            // A digit, and a blank or the line's end after it.
            (Encoding::Ascii, _) => 2,
            (_, Kind::Scalar(scalar) | Kind::List { count: scalar, .. }) => scalar.size(),
        };
        self.properties.iter().map(size).sum()
    }
}

pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Its length in bytes, the end of its last line included, and in lines.
    pub(super) length: usize,
    pub(super) lines: usize,
}

/// Reads the header of the file `bytes`. Comments are of any encoding.
pub(super) fn read(bytes: &[u8]) -> Result<Header, MeshError> {
    let mut all = (1..).zip(lines(bytes));
    let wrong = |number| at_line(bytes, number, "is not understood");
    let (_, first) = all.next().unwrap_or_default();
    if first.trim_ascii() != b"ply" {
        return Err(wrong(1));
    }
    // A binary body may begin with what looks like the second half of a line's end.
    let is_bare_cr =
        bytes[first.len()..].starts_with(b"\r") && !bytes[first.len()..].starts_with(b"\r\n");
    let (mut encoding, mut elements) = (None, Vec::new());
    for (number, line) in all {
        let end = line.as_ptr() as usize - bytes.as_ptr() as usize + line.len();
        let text = str::from_utf8(line).unwrap_or_default();
        let words: Vec<&str> = text.split_whitespace().collect();
        let understood = match words[..] {
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
                encoding.is_some()
            }
            ["element", name, count] => element(&mut elements, name, count)?,
            ["property", ref words @ ..] => property(&mut elements, words)?,
            _ => is_comment(line),
        };
        if !understood {
            return Err(wrong(number));
        }
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

/// A comment may be in Latin-1; a blank line says nothing.
fn is_comment(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    line.is_empty()
        || [&b"comment"[..], b"obj_info"]
            .iter()
            .any(|word| line.starts_with(word))
}

/// `element NAME COUNT`; whether it is understood.
fn element(elements: &mut Vec<Element>, name: &str, count: &str) -> Result<bool, MeshError> {
    let Ok(count) = count.parse() else {
        return Ok(false);
    };
    unique(elements.iter().map(|element| &*element.name), name)?;
    elements.push(Element {
        name: name.into(),
        count,
        properties: Vec::new(),
    });
    Ok(true)
}

/// The words after `property`: `TYPE NAME` or `list TYPE TYPE NAME`; whether they are understood.
fn property(elements: &mut [Element], words: &[&str]) -> Result<bool, MeshError> {
    let (kind, name) = match *words {
        ["list", count, of, name] => match (Scalar::of(count), Scalar::of(of)) {
            (Some(count), Some(of)) if count.is_integer() => (Kind::List { count, of }, name),
            _ => return Ok(false),
        },
        [scalar, name] => match Scalar::of(scalar) {
            Some(scalar) => (Kind::Scalar(scalar), name),
            None => return Ok(false),
        },
        _ => return Ok(false),
    };
    let Some(element) = elements.last_mut() else {
        return Ok(false);
    };
    let names = element.properties.iter().map(|property| &*property.name);
    unique(names, name)?;
    let name = name.into();
    element.properties.push(Property { name, kind });
    Ok(true)
}

/// With a name that stands twice it is not clear which of the two is meant.
fn unique<'a>(mut names: impl Iterator<Item = &'a str>, name: &str) -> Result<(), MeshError> {
    match names.any(|other| other == name) {
        true => Err(MeshError::Malformed(
            "a name stands twice in its header".into(),
        )),
        false => Ok(()),
    }
}

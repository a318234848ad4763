//! Writes PLY files for tests, by the format's description and not with the crate that reads them.

#[derive(Clone, Copy, Debug)]
pub enum Scalar {
    I8(i8),
    U8(u8),
    I16(i16),
    U16(u16),
    I32(i32),
    U32(u32),
    F32(f32),
    F64(f64),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Encoding {
    Ascii,
    Little,
    Big,
}

pub const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::Little, Encoding::Big];

/// A file of `rows`, an element each, under the `declarations` of its header.
pub fn file(encoding: Encoding, declarations: &str, rows: &[Vec<Scalar>]) -> Vec<u8> {
    let name = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::Little => "binary_little_endian",
        Encoding::Big => "binary_big_endian",
    };
    let mut bytes = format!("ply\nformat {name} 1.0\n{declarations}end_header\n").into_bytes();
    for row in rows {
        if encoding == Encoding::Ascii {
            let words: Vec<_> = row.iter().map(text).collect();
            bytes.extend(format!("{}\n", words.join(" ")).bytes());
        } else {
            bytes.extend(row.iter().flat_map(|scalar| binary(scalar, encoding)));
        }
    }
    bytes
}

fn text(scalar: &Scalar) -> String {
    match scalar {
        Scalar::I8(v) => v.to_string(),
        Scalar::U8(v) => v.to_string(),
        Scalar::I16(v) => v.to_string(),
        Scalar::U16(v) => v.to_string(),
        Scalar::I32(v) => v.to_string(),
        Scalar::U32(v) => v.to_string(),
        Scalar::F32(v) => v.to_string(),
        Scalar::F64(v) => v.to_string(),
    }
}

fn binary(scalar: &Scalar, encoding: Encoding) -> Vec<u8> {
    let mut bytes = match scalar {
        Scalar::I8(v) => v.to_le_bytes().to_vec(),
        Scalar::U8(v) => v.to_le_bytes().to_vec(),
        Scalar::I16(v) => v.to_le_bytes().to_vec(),
        Scalar::U16(v) => v.to_le_bytes().to_vec(),
        Scalar::I32(v) => v.to_le_bytes().to_vec(),
        Scalar::U32(v) => v.to_le_bytes().to_vec(),
        Scalar::F32(v) => v.to_le_bytes().to_vec(),
        Scalar::F64(v) => v.to_le_bytes().to_vec(),
    };
    if encoding == Encoding::Big {
        bytes.reverse();
    }
    bytes
}

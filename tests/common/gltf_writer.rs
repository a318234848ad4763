//! Writes glTF for tests, by the format's description and not with the crate that reads it.

use serde_json::{Value, json};

pub const I8: u32 = 5120;
pub const U8: u32 = 5121;
pub const I16: u32 = 5122;
pub const U16: u32 = 5123;
pub const U32: u32 = 5125;
pub const F32: u32 = 5126;

/// A buffer, with a view and an accessor for each array that it contains.
#[derive(Default)]
pub struct Buffer {
    pub bytes: Vec<u8>,
    pub views: Vec<Value>,
    pub accessors: Vec<Value>,
}

impl Buffer {
    /// Adds an array of scalars and returns its accessor.
    pub fn scalars(&mut self, kind: u32, rows: &[u32]) -> usize {
        let bytes = rows
            .iter()
            .flat_map(|i| number(kind, f64::from(*i)))
            .collect();
        self.array(
            bytes,
            json!({"type": "SCALAR", "componentType": kind, "count": rows.len()}),
        )
    }

    /// Adds an array of vectors or matrices and returns its accessor.
    pub fn vectors<const N: usize>(&mut self, kind: u32, rows: &[[f64; N]]) -> usize {
        let bytes = rows
            .iter()
            .flatten()
            .flat_map(|x| number(kind, *x))
            .collect();
        let shape = match N {
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        self.array(
            bytes,
            json!({"type": shape, "componentType": kind, "count": rows.len()}),
        )
    }

    /// Adds an array of vectors of three, each 4 bytes into `stride` bytes of other data.
    pub fn interleaved(&mut self, kind: u32, rows: &[[f64; 3]], stride: usize) -> usize {
        let mut bytes = Vec::new();
        for row in rows {
            bytes.resize(bytes.len().next_multiple_of(stride), 0xff);
            bytes.extend([0xff; 4]);
            bytes.extend(row.iter().flat_map(|x| number(kind, *x)));
        }
        let accessor =
            json!({"type": "VEC3", "componentType": kind, "count": rows.len(), "byteOffset": 4});
        let index = self.array(bytes, accessor);
        self.views[index]["byteStride"] = json!(stride);
        index
    }

    fn array(&mut self, bytes: Vec<u8>, mut accessor: Value) -> usize {
        let (start, length) = (self.bytes.len(), bytes.len());
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        accessor["bufferView"] = json!(self.views.len());
        self.views
            .push(json!({"buffer": 0, "byteOffset": start, "byteLength": length}));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

fn number(kind: u32, x: f64) -> Vec<u8> {
    match kind {
        I8 => (x as i8).to_le_bytes().to_vec(),
        U8 => (x as u8).to_le_bytes().to_vec(),
        I16 => (x as i16).to_le_bytes().to_vec(),
        U16 => (x as u16).to_le_bytes().to_vec(),
        U32 => (x as u32).to_le_bytes().to_vec(),
        _ => (x as f32).to_le_bytes().to_vec(),
    }
}

/// A GLB of a document and the bytes of its first buffer.
pub fn glb(document: &Value, bin: &[u8]) -> Vec<u8> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bin = bin.to_vec();
    bin.resize(bin.len().next_multiple_of(4), 0);
    chunks(&[(b"JSON", &json), (b"BIN\0", &bin)])
}

/// A GLB of chunks.
pub fn chunks(chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let word = |n: usize| (n as u32).to_le_bytes();
    let chunk = |(kind, bytes): &(&[u8; 4], &[u8])| [&word(bytes.len()), &kind[..], bytes].concat();
    let body: Vec<u8> = chunks.iter().flat_map(chunk).collect();
    [b"glTF", &word(2)[..], &word(12 + body.len()), &body].concat()
}

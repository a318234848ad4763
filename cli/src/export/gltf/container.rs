//! The file: a GLB (glTF 2.0, section 4, *GLB File Format Specification*), or JSON with a separate buffer.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use serde_json::{Value, json};

use super::buffer::Buffer;
use crate::export::Beside;

/// The container of the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Container {
    Glb,
    /// `.gltf` with a separate `.bin`.
    Json,
}

const VERSION: u32 = 2;

/// Length in bytes of the header, and of a chunk's header.
const HEADER: usize = 12;
const CHUNK: usize = 8;

/// The characters that `uri` keeps unencoded (RFC 3986, section 2.3, *Unreserved Characters*).
const ENCODED: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'.')
    .remove(b'_')
    .remove(b'~');

impl Container {
    /// The largest buffer of a GLB, whose length is a `u32`: half a GiB is reserved for the JSON.
    pub const MOST: usize = 0xE000_0000;

    /// The bytes of the file, and of its separate buffer.
    pub fn around(
        self,
        mut document: Value,
        buffer: Buffer,
        stem: &str,
    ) -> (Vec<u8>, Option<Beside>) {
        let bytes = buffer.into_bytes();
        document["buffers"] = json!([{ "byteLength": bytes.len() }]);
        match self {
            Self::Glb => (glb(document.to_string().into_bytes(), bytes), None),
            Self::Json => {
                let name = format!("{stem}.bin");
                document["buffers"][0]["uri"] = json!(uri(&name));
                (
                    format!("{document:#}\n").into_bytes(),
                    Some(Beside { name, bytes }),
                )
            }
        }
    }
}

fn glb(mut json: Vec<u8>, mut binary: Vec<u8>) -> Vec<u8> {
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = HEADER + CHUNK + json.len() + CHUNK + binary.len();
    let mut file = b"glTF".to_vec();
    file.extend(VERSION.to_le_bytes());
    file.extend((length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", binary)] {
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

/// A file's name as a relative URI.
fn uri(name: &str) -> String {
    utf8_percent_encode(name, ENCODED).to_string()
}

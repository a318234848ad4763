//! glTF and GLB files that are broken, or ask for too much.

use std::path::Path;

use glam::DVec3;
use serde_json::{Value, json};
use vkpt::scene::{parse_mesh, read_mesh};

use super::gltf::{CORNERS, one, plain, read, square};
use crate::common::gltf_writer::{Buffer, F32, U8, glb};

/// A pointer into the document, the value put there, and the message.
const FAULTS: [(&str, &str, &str); 37] = [
    ("/scene", "7", "its default scene does not exist"),
    ("/scenes/0/nodes/0", "7", "node 7 does not exist"),
    ("/nodes/0/children", "[0]", "node 0 is in its scene twice"),
    ("/scenes/0/nodes", "[0,0]", "node 0 is in its scene twice"),
    ("/scenes/0/nodes", "[]", "it has no triangles"),
    ("/nodes/0/mesh", "7", "mesh 7 does not exist"),
    ("/nodes/0/mesh", "-1", "cannot read its JSON"),
    (
        "/nodes/0/matrix",
        "[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]",
        "the matrix of node 0 has a last row other than 0 0 0 1",
    ),
    (
        "/nodes/0/scale",
        "[1,3e38,1]",
        "mesh 0, primitive 0: its vertex 2 is not finite in single precision",
    ),
    (
        "/nodes/0/rotation",
        "[0,0,0,0]",
        "the rotation of node 0 is zero",
    ),
    ("/meshes/0/primitives", "[]", "it has no triangles"),
    (
        "/meshes/0/primitives/0/mode",
        "9",
        "mesh 0, primitive 0: its mode 9 is unknown",
    ),
    (
        "/meshes/0/primitives/0/attributes",
        "{}",
        "mesh 0, primitive 0: it has no positions",
    ),
    (
        "/meshes/0/primitives/0/attributes/POSITION",
        "9",
        "mesh 0, primitive 0: accessor 9: it does not exist",
    ),
    (
        "/meshes/0/primitives/0/attributes/POSITION",
        "1",
        "mesh 0, primitive 0: accessor 1: its elements are not VEC3",
    ),
    (
        "/meshes/0/primitives/0/attributes/NORMAL",
        "3",
        "mesh 0, primitive 0: it has 3 normals for 4 vertices",
    ),
    (
        "/meshes/0/primitives/0/indices",
        "0",
        "mesh 0, primitive 0: accessor 0: its elements are not SCALAR",
    ),
    (
        "/accessors/1/componentType",
        "5126",
        "mesh 0, primitive 0: accessor 1: its numbers are not indices",
    ),
    (
        "/accessors/1/componentType",
        "5122",
        "mesh 0, primitive 0: accessor 1: its numbers are not indices",
    ),
    (
        "/accessors/1/componentType",
        "77",
        "mesh 0, primitive 0: accessor 1: its component type 77 is unknown",
    ),
    ("/accessors/1/count", "0", "it has no triangles"),
    (
        "/accessors/0/count",
        "3",
        "mesh 0, primitive 0: it refers to vertex 3, but there are 3",
    ),
    (
        "/accessors/0/count",
        "5",
        "mesh 0, primitive 0: accessor 0: its 5 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/accessors/0/count",
        "18446744073709551615",
        "its nodes together have more than 67108864 vertices or corners",
    ),
    (
        "/accessors/0/count",
        "1000000",
        "mesh 0, primitive 0: accessor 0: it declares 1000000 elements, but there are only 144 bytes",
    ),
    (
        "/accessors/0/byteOffset",
        "1",
        "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/accessors/0/byteOffset",
        "18446744073709551615",
        "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/accessors/0/bufferView",
        "9",
        "mesh 0, primitive 0: accessor 0: buffer view 9 does not exist",
    ),
    (
        "/accessors/0/bufferView",
        "null",
        "mesh 0, primitive 0: accessor 0: it has no data",
    ),
    (
        "/bufferViews/0/buffer",
        "9",
        "mesh 0, primitive 0: accessor 0: buffer 9 does not exist",
    ),
    (
        "/bufferViews/0/byteLength",
        "47",
        "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/bufferViews/0/byteOffset",
        "18446744073709551615",
        "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/bufferViews/0/byteStride",
        "4",
        "mesh 0, primitive 0: accessor 0: its elements of 12 bytes are only 4 bytes apart",
    ),
    (
        "/bufferViews/0/byteStride",
        "18446744073709551615",
        "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer",
    ),
    (
        "/buffers/0/byteLength",
        "1000000000000",
        "its buffer 0 is truncated: it declares 1000000000000 bytes, but has 144",
    ),
    ("/asset", "7", "cannot read its JSON"),
    ("/scenes/0/nodes", "7", "cannot read its JSON"),
];

#[test]
fn mistakes_are_named() {
    let mut buffer = square();
    buffer.vectors(F32, &CORNERS[..3]);
    let document = one(
        &buffer,
        json!({"attributes": {"POSITION": 0}, "indices": 1}),
    );
    read(&document, &buffer.bytes).expect("a mesh");
    for (pointer, value, message) in FAULTS {
        let mut document = document.clone();
        let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
        let value: Value = serde_json::from_str(value).expect(value);
        match document.pointer_mut(parent).expect(parent) {
            Value::Array(array) => array[name.parse::<usize>().expect(name)] = value,
            object => object[name] = value,
        }
        let words = match read(&document, &buffer.bytes) {
            Ok(mesh) => panic!("{pointer} {message}: read as {mesh:?}"),
            Err(error) => error.to_string(),
        };
        // The rest is the JSON reader's.
        let words = words.split(" its JSON: ").next().unwrap_or_default();
        let message = message.trim_end_matches(" its JSON");
        assert_eq!(words, message, "{pointer}");
    }
}

#[test]
fn addresses_that_lead_nowhere() {
    let (mut document, bin) = plain();
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("short.bin"), &bin[..9]).expect("a file");
    let rows = [
        (
            "none.bin",
            "cannot be read: the file `none.bin` does not exist",
        ),
        (
            "short.bin",
            "is truncated: it declares 108 bytes, but has 9",
        ),
        (
            "Short.BIN",
            "cannot be read: the file `Short.BIN` does not exist, but `short.bin` does: rename one of them",
        ),
        ("/dev/zero", "cannot be read: `/dev/zero`: it is not a file"),
        (".", "cannot be read: `.`: it is not a file"),
        (
            "https://example.org/a.bin",
            "cannot be read: `https://example.org/a.bin` is not a file next to it",
        ),
        ("data:,text", "cannot be read: `data:,text` is not base64"),
        (
            "data:;base64,AA",
            "is truncated: it declares 108 bytes, but has 1",
        ),
        (
            "data:;base64,A*",
            "cannot be read: Invalid symbol 42, offset 1.",
        ),
        (
            "%ff\u{7}",
            "cannot be read: the file `%ff\u{fffd}` does not exist",
        ),
    ];
    for (uri, message) in rows {
        document["buffers"][0]["uri"] = json!(uri);
        let path = folder.path().join("mesh.gltf");
        std::fs::write(&path, document.to_string()).expect("a file");
        let words = read_mesh(&path).expect_err(uri).to_string();
        assert_eq!(words, format!("its buffer 0 {message}"));
    }
    let alone = parse_mesh(plain().0.to_string().as_bytes(), Path::new("mesh.gltf"));
    let words = alone.expect_err("no buffer").to_string();
    assert_eq!(
        words,
        "its buffer 0 has no data: no `uri`, and no binary chunk as in GLB"
    );
}

/// Forty nodes, each with the next one twice below it, would be 2⁴⁰; and 2300 instances of a mesh of 10,000
/// triangles are too many as well.
#[test]
fn small_files_cannot_ask_for_large_meshes() {
    let (mut document, bin) = plain();
    let doubling = (0..40).map(|i| json!({"children": [i + 1, i + 1]}));
    document["nodes"] = doubling.chain([json!({"mesh": 0})]).collect();
    let words = read(&document, &bin).expect_err("too many").to_string();
    assert_eq!(words, "node 1 is listed as a child twice");
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &CORNERS[..3]);
    buffer.scalars(U8, &[0, 1, 2].repeat(10_000));
    let mut document = one(
        &buffer,
        json!({"attributes": {"POSITION": 0}, "indices": 1}),
    );
    document["nodes"] = (0..2300).map(|_| json!({"mesh": 0})).collect();
    (document["scenes"], document["scene"]) = (json!([]), Value::Null);
    let words = read(&document, &buffer.bytes)
        .expect_err("too many")
        .to_string();
    assert_eq!(
        words,
        "its nodes together have more than 67108864 vertices or corners"
    );
}

/// A file that is read must keep the promises.
fn try_bytes(bytes: &[u8]) {
    if let Ok(mesh) = parse_mesh(bytes, Path::new("tests/mesh.glb")) {
        let vertices = mesh.positions.len() as u32;
        assert!(!mesh.triangles.is_empty());
        assert!(mesh.triangles.iter().flatten().all(|i| *i < vertices));
        assert!(mesh.positions.iter().all(|p| p.as_vec3().is_finite()));
        let normals = mesh.normals.unwrap_or_default();
        assert!(
            normals
                .iter()
                .all(|n| *n == DVec3::ZERO || n.is_normalized())
        );
    }
}

#[test]
fn a_file_cut_anywhere_is_an_error_and_never_a_panic() {
    let (document, bin) = plain();
    let whole = glb(&document, &bin);
    for length in 0..whole.len() {
        let cut = parse_mesh(&whole[..length], Path::new("mesh.glb"));
        assert!(cut.is_err(), "{length} of {}", whole.len());
        // And with a header that owns up to it.
        let mut honest = whole[..length].to_vec();
        if length >= 12 {
            honest[8..12].copy_from_slice(&(length as u32).to_le_bytes());
        }
        assert!(
            parse_mesh(&honest, Path::new("mesh.glb")).is_err(),
            "{length}"
        );
    }
}

#[test]
fn damaged_files_never_panic() {
    let mut buffer = square();
    buffer.scalars(U8, &[1]);
    let mut document = one(
        &buffer,
        json!({"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1, "mode": 4}),
    );
    document["accessors"][0]["sparse"] = json!({
        "count": 1, "values": {"bufferView": 2},
        "indices": {"bufferView": 3, "componentType": U8},
    });
    document["nodes"] =
        json!([{"children": [1]}, {"mesh": 0, "matrix": [2,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]}]);
    never_panics(&document, &buffer.bytes);
}

/// Tries a file that is read with many faults of a few bytes each.
pub fn never_panics(document: &Value, bin: &[u8]) {
    let whole = glb(document, bin);
    read(document, bin).expect("a mesh");
    let mut random = super::fuzz::Random(5);
    let digits = b"0123456789-e.[]{},\"";
    for round in 0..12_000 {
        let mut bytes = whole.clone();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            bytes[at] = match (round % 3, random.below(2)) {
                // Most of the file is JSON; changing one number into another has the widest effect.
                (0, _) if !bytes[at].is_ascii_digit() => continue,
                (0, _) => digits[random.below(10)],
                (_, 0) => digits[random.below(digits.len())],
                _ => random.next() as u8,
            };
        }
        try_bytes(&bytes);
    }
}

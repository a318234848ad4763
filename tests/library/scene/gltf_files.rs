//! Containers of glTF files: GLB or JSON alone, buffers within them and next to them; and their requirements on a reader.

use std::path::Path;

use serde_json::{Value, json};
use vkpt::scene::{MeshError, MeshFile, parse_mesh, read_mesh};

use super::gltf::{add, plain, read};
use crate::common::gltf_writer::{chunks, glb};

fn parse(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    parse_mesh(bytes, Path::new("mesh.glb"))
}

/// The document of [`plain`] with its buffer within it.
fn alone() -> Value {
    let (mut document, bin) = plain();
    let base64 = base64::Engine::encode(&base64::prelude::BASE64_STANDARD, &bin);
    document["buffers"][0]["uri"] = json!(format!("data:application/octet-stream;base64,{base64}"));
    document
}

#[test]
fn json_may_be_padded_and_begin_with_a_byte_order_mark() {
    let (document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    for padding in [
        "", " ", "   ", "\0", "\0\0\0", "\n", "\r\n\t ", " \0 \0", "\u{c}",
    ] {
        for mark in ["", "\u{feff}"] {
            let json = format!("{mark}{document}{padding}");
            let glb = chunks(&[(b"JSON", json.as_bytes()), (b"BIN\0", &bin)]);
            assert_eq!(parse(&glb).expect("a mesh"), expected, "{padding:?}");
            let json = format!("{mark}{}{padding}", alone());
            let mesh = parse(json.as_bytes()).expect("a mesh");
            assert_eq!(mesh, expected, "{padding:?}");
        }
    }
}

#[test]
fn the_bytes_distinguish_json_from_glb_and_not_the_ending() {
    let (document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    let json = alone().to_string().into_bytes();
    for bytes in [glb(&document, &bin), json] {
        for ending in ["gltf", "glb", "GLTF", "Glb"] {
            let path = format!("mesh.{ending}");
            let mesh = parse_mesh(&bytes, Path::new(&path));
            assert_eq!(mesh.expect(ending), expected);
        }
    }
}

/// A name that is no UTF-8.
#[test]
fn names_may_be_in_another_encoding() {
    let mut document = alone();
    document["nodes"][0]["name"] = json!("Tur~");
    let mut bytes = document.to_string().into_bytes();
    let at = bytes.iter().position(|b| *b == b'~').expect("a tilde");
    bytes[at] = 0xfc;
    parse(&bytes).expect("a mesh");
}

/// Chunks of unknown kinds are skipped (glTF 2.0, section 4.4.3), and truncated ones give an error.
#[test]
fn chunks_are_known_by_their_kinds() {
    let (document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    let json = document.to_string().into_bytes();
    let (json, bin): (_, (&[u8; 4], &[u8])) = ((b"JSON", &json[..]), (b"BIN\0", &bin));
    let other = (b"xyz\0", &b"1234567"[..]);
    for all in [
        vec![json, bin, other],
        vec![json, other, bin],
        vec![json, bin, bin],
    ] {
        assert_eq!(parse(&chunks(&all)).expect("a mesh"), expected);
    }
    let whole = chunks(&[json, bin]);
    let with = |at: usize, word: u32| {
        let mut bytes = whole.clone();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        bytes
    };
    let (length, of_json) = (whole.len(), json.1.len());
    let after = length - 20;
    let rows = [
        (
            chunks(&[bin, json]),
            "its first chunk is not JSON".to_owned(),
        ),
        (
            chunks(&[json]),
            "its buffer 0 has no data: no `uri`, and no binary chunk as in GLB".into(),
        ),
        (
            with(8, length as u32 + 1),
            format!(
                "it is truncated: it declares {} bytes, but has {length}",
                length + 1
            ),
        ),
        (
            with(8, 3),
            format!("it is truncated: it declares 3 bytes, but has {length}"),
        ),
        (
            with(8, 14),
            "it is truncated within the header of a chunk".into(),
        ),
        (
            with(12, u32::MAX),
            format!("it is truncated: a chunk declares 4294967295 bytes, but {after} follow"),
        ),
        (
            with(20 + of_json, 109),
            "it is truncated: a chunk declares 109 bytes, but 108 follow".into(),
        ),
        (
            with(4, 1),
            "it is glTF 1.0, but only 2.0 is supported: convert it".into(),
        ),
        (
            with(4, 3),
            "it is glTF 3.0, but only 2.0 is supported: convert it".into(),
        ),
    ];
    for (bytes, message) in rows {
        assert_eq!(parse(&bytes).expect_err("no mesh").to_string(), message);
    }
}

/// glTF 1.0 has objects where 2.0 has arrays; the message is about the version only.
#[test]
fn other_versions_are_refused_by_name() {
    let mut document = alone();
    let no_version = "it has no `asset.version`, which glTF 2.0 requires";
    let rows = [
        (json!({"version": "2.0"}), ""),
        (json!({"version": "2.1", "minVersion": "2.0"}), ""),
        (json!({"version": "2.0", "generator": 7}), ""),
        (json!({"version": 2.0}), ""),
        (json!({"version": 2}), ""),
        (
            json!({"version": "1.0"}),
            "it is glTF 1.0, but only 2.0 is supported: convert it",
        ),
        (
            json!({"version": "1.1"}),
            "it is glTF 1.1, but only 2.0 is supported: convert it",
        ),
        (
            json!({"version": "3.0"}),
            "it is glTF 3.0, but only 2.0 is supported: convert it",
        ),
        (
            json!({"version": "20.0"}),
            "it is glTF 20.0, but only 2.0 is supported: convert it",
        ),
        (
            json!({"version": "2.1", "minVersion": "2.1"}),
            "it needs glTF 2.1 or later, but only 2.0 is supported: export it as glTF 2.0",
        ),
        (json!({"generator": "x"}), no_version),
        (Value::Null, no_version),
    ];
    for (asset, message) in rows {
        document["asset"] = asset.clone();
        let read = parse(document.to_string().as_bytes());
        let words = read
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default();
        assert_eq!(words, message, "{asset}");
    }
    let first = json!({"asset": {"version": "1.0"}, "meshes": {"a": {}}, "nodes": {"b": {}}});
    let words = parse(first.to_string().as_bytes()).expect_err("no mesh");
    assert_eq!(
        words.to_string(),
        "it is glTF 1.0, but only 2.0 is supported: convert it"
    );
}

#[test]
fn extensions_that_change_the_meaning_must_be_known() {
    let (mut document, bin) = plain();
    let harmless = [
        "KHR_mesh_quantization",
        "KHR_materials_unlit",
        "KHR_texture_basisu",
        "KHR_lights_punctual",
    ];
    document["extensionsRequired"] = json!(harmless);
    // None of this is inspected.
    document["textures"] = json!([{"extensions": {"KHR_texture_basisu": {"source": 0}}}]);
    document["images"] = json!([{"uri": "none.ktx2"}]);
    read(&document, &bin).expect("a mesh");
    let compressed = ": its mesh is compressed, save it without compression";
    let rows: [(&[&str], &str); 6] = [
        (&["VENDOR_x"], ""),
        (&["EXT_mesh_gpu_instancing", "VENDOR_x"], ""),
        (&["KHR_draco_mesh_compression"], compressed),
        (&["EXT_meshopt_compression"], compressed),
        (&["KHR_meshopt_compression"], compressed),
        (&["VENDOR_x", "KHR_draco_mesh_compression"], compressed),
    ];
    for (names, why) in rows {
        document["extensionsRequired"] = json!([&harmless[..2], names, &harmless[2..]].concat());
        let words = read(&document, &bin).expect_err("not read").to_string();
        let [extensions, are] = match names.len() {
            1 => ["extension", "is"],
            _ => ["extensions", "are"],
        };
        let names = names.join("`, `");
        assert_eq!(
            words,
            format!("it requires the {extensions} `{names}`, which {are} not supported{why}")
        );
    }
}

/// Compressed data that are not required have an uncompressed copy; if it is missing, there is an error.
#[test]
fn compression_that_is_not_required_leaves_a_copy() {
    let (mut document, bin) = plain();
    let draco = json!({"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}});
    document["meshes"][0]["primitives"][0]["extensions"] = draco;
    let meshopt = json!({"EXT_meshopt_compression": {"buffer": 0, "byteLength": 9}});
    document["bufferViews"][0]["extensions"] = meshopt;
    read(&document, &bin).expect("a mesh");
    let by = |name: &str| format!("it is compressed by {name}, save it without compression");
    let mut without = document.clone();
    without["accessors"][0]["bufferView"] = Value::Null;
    assert_eq!(
        read(&without, &bin).expect_err("no data").to_string(),
        format!(
            "mesh 0, primitive 0: accessor 0: it has no data: {}",
            by("KHR_draco_mesh_compression")
        )
    );
    let primitive = &mut document["meshes"][0]["primitives"][0];
    primitive["extensions"] = json!({});
    let mut short = document.clone();
    short["bufferViews"][0]["byteLength"] = json!(9);
    assert_eq!(
        read(&short, &bin).expect_err("no data").to_string(),
        format!(
            "mesh 0, primitive 0: accessor 0: its 4 elements of 12 bytes reach beyond their buffer: {}",
            by("EXT_meshopt_compression")
        )
    );
    add(
        &mut document,
        "buffers",
        json!({"byteLength": 48, "extensions": {"EXT_meshopt_compression": {}}}),
    );
    document["bufferViews"][0]["buffer"] = json!(1);
    let words = read(&document, &bin).expect_err("no data").to_string();
    let no_data = "its buffer 1 has no data: no `uri`, and no binary chunk as in GLB";
    assert_eq!(
        words,
        format!("{no_data}: {}", by("EXT_meshopt_compression"))
    );
}

#[test]
fn buffers_in_the_file_and_beside_it_are_the_same() {
    let (document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("sub")).expect("a folder");
    // Longer than the document says.
    let more = [&bin[..], b"more"].concat();
    for name in ["a b.bin", "50%25.bin", "ü.bin", "sub/c d.bin"] {
        std::fs::write(folder.path().join(name), &more).expect("a file");
    }
    let base64 = base64::Engine::encode(&base64::prelude::BASE64_STANDARD, &bin);
    let rows = [
        ("a%20b.bin", Some("a b.bin")),
        ("a b.bin", Some("a b.bin")),
        ("./a b.bin", Some("./a b.bin")),
        // As in the format, and verbatim.
        ("50%2525.bin", Some("50%25.bin")),
        ("50%25.bin", Some("50%25.bin")),
        ("%C3%BC.bin", Some("ü.bin")),
        ("ü.bin", Some("ü.bin")),
        ("sub\\c%20d.bin", Some("sub/c d.bin")),
        (".\\sub\\c d.bin", Some("./sub/c d.bin")),
        (
            &format!("data:application/octet-stream;base64,{base64}"),
            None,
        ),
        (
            &format!("data:application/gltf-buffer;base64,{base64}"),
            None,
        ),
        (&format!("data:;base64,{base64}"), None),
        (
            &format!("DATA:text/plain;charset=utf-8;BASE64,{base64}"),
            None,
        ),
        (
            &format!("data:;base64,{}", base64.trim_end_matches('=')),
            None,
        ),
        (
            &format!("data:;base64,{}", base64.replace('+', "%2B")),
            None,
        ),
    ];
    for (uri, beside) in rows {
        let mut document = document.clone();
        document["buffers"][0]["uri"] = json!(uri);
        let path = folder.path().join("mesh.gltf");
        std::fs::write(&path, document.to_string()).expect("a file");
        let mut mesh = read_mesh(&path).expect(uri);
        let files = beside.map(|name| folder.path().join(name));
        assert_eq!(
            std::mem::take(&mut mesh.files),
            Vec::from_iter(files),
            "{uri}"
        );
        assert_eq!(mesh, expected, "{uri}");
    }
}

/// Those of pictures and animations.
#[test]
fn buffers_that_no_mesh_uses_may_be_missing() {
    let (mut document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    add(
        &mut document,
        "buffers",
        json!({"byteLength": 1e6 as u64, "uri": "none.bin"}),
    );
    add(
        &mut document,
        "bufferViews",
        json!({"buffer": 1, "byteLength": 9}),
    );
    add(
        &mut document,
        "accessors",
        json!({"bufferView": 3, "componentType": 5126, "count": 9, "type": "SCALAR"}),
    );
    assert_eq!(read(&document, &bin).expect("a mesh"), expected);
}

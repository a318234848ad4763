//! Files of other kinds under the ending of a mesh.

use std::path::Path;

use vkpt::scene::parse_mesh;

use super::gltf::plain;

const ENDINGS: [&str; 4] = ["ply", "obj", "gltf", "glb"];

#[test]
fn files_of_other_kinds_are_named() {
    let page = "it is a web page: download the file itself";
    let rows: [(&[u8], &str); 8] = [
        (b"", "it is empty"),
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
            "it is a Git LFS pointer, not the file itself: fetch the file with `git lfs pull`",
        ),
        (b"<!DOCTYPE html>\n<html lang=\"en\">", page),
        (b"\xef\xbb\xbf \r\n<!doctype HTML>", page),
        (b"<html><head>", page),
        (b"PK\x03\x04\x14\0\0\0", "it is a ZIP archive: unpack it"),
        (b"\x1f\x8b\x08\0", "it is compressed by gzip: unpack it"),
        (b"\x28\xb5\x2f\xfd\0", "it is compressed by zstd: unpack it"),
    ];
    for (bytes, message) in rows {
        for ending in ENDINGS {
            let path = format!("mesh.{ending}");
            let read = parse_mesh(bytes, Path::new(&path));
            assert_eq!(read.expect_err(message).to_string(), message, "{ending}");
        }
    }
}

#[test]
fn so_is_utf_16() {
    let json = plain().0.to_string();
    for (text, ending) in [
        (&*json, "gltf"),
        (&json, "glb"),
        ("v 0 0 0\n", "obj"),
        ("ply\r\nformat ascii 1.0\r\n", "ply"),
        ("# größer\n", "obj"),
    ] {
        for mark in ["", "\u{feff}"] {
            let units: Vec<u16> = format!("{mark}{text}").encode_utf16().collect();
            let little: Vec<u8> = units.iter().flat_map(|u| u.to_le_bytes()).collect();
            let big: Vec<u8> = units.iter().flat_map(|u| u.to_be_bytes()).collect();
            for bytes in [little, big] {
                let path = format!("mesh.{ending}");
                let words = parse_mesh(&bytes, Path::new(&path)).expect_err(ending);
                assert_eq!(words.to_string(), "it is UTF-16: save it as UTF-8");
            }
        }
    }
}

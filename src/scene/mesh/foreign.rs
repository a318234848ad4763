//! Recognises common files that are neither meshes nor scenes, so that messages name the kind of file instead of the
//! first parse error.

/// How a file of another kind begins, and the message about it.
const BEGINNINGS: [(&[u8], &str); 6] = [
    (
        b"version https://git-lfs",
        "it is a Git LFS pointer, not the file itself: fetch the file with `git lfs pull`",
    ),
    (
        b"<!doctype html",
        "it is a web page: download the file itself",
    ),
    (b"<html", "it is a web page: download the file itself"),
    (b"PK\x03\x04", "it is a ZIP archive: unpack it"),
    (b"\x1f\x8b", "it is compressed by gzip: unpack it"),
    (b"\x28\xb5\x2f\xfd", "it is compressed by zstd: unpack it"),
];

/// A message about `bytes` if they belong to no supported kind of file.
pub fn foreign(bytes: &[u8]) -> Option<&'static str> {
    if bytes.is_empty() {
        return Some("it is empty");
    }
    if is_utf_16(bytes) {
        return Some("it is UTF-16: save it as UTF-8");
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = text.trim_ascii_start();
    let begins = |start: &[u8]| {
        text.get(..start.len())
            .is_some_and(|text| text.eq_ignore_ascii_case(start))
    };
    let found = BEGINNINGS.iter().find(|(start, _)| begins(start));
    found.map(|(_, what)| *what)
}

/// Recognised by the byte order mark, or by the zero bytes among the first letters.
fn is_utf_16(bytes: &[u8]) -> bool {
    match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        [a, 0, b, 0, ..] | [0, a, 0, b, ..] => *a != 0 && *b != 0,
        _ => false,
    }
}

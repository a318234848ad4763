//! The content behind a buffer's URI: embedded data, or a file relative to the document.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;

use crate::scene::text::quote;

const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The bytes of `data:…;base64,…`, or the first `length` bytes of a file relative to `folder`, with the file's path.
/// Errors are messages.
pub(super) fn bytes_at(
    uri: &str,
    length: u64,
    folder: &Path,
) -> Result<(Vec<u8>, Option<PathBuf>), String> {
    let quoted = quote(uri);
    match uri.split_once(':') {
        Some((scheme, data)) if scheme.eq_ignore_ascii_case("data") => {
            let bytes = decode(data).ok_or_else(|| format!("`{quoted}` is not base64"))?;
            Ok((bytes.map_err(|error| error.to_string())?, None))
        }
        // A colon in a relative reference must be encoded: this is a scheme.
        Some(_) => Err(format!("`{quoted}` is not a file next to it")),
        None => {
            let path = find(uri, folder)?;
            let bytes = read(&path, length).map_err(|reason| format!("`{quoted}`: {reason}"))?;
            Ok((bytes, Some(path)))
        }
    }
}

/// The text after `data:` (RFC 2397): a media type with its parameters, the last of which is `base64`, and the data.
fn decode(data: &str) -> Option<Result<Vec<u8>, base64::DecodeError>> {
    let (kind, text) = data.split_once(',')?;
    let is_base64 = |parameter: &str| parameter.trim().eq_ignore_ascii_case("base64");
    kind.split(';').any(is_base64).then_some(())?;
    let text: std::borrow::Cow<[u8]> = percent_decode_str(text).into();
    Some(BASE64.decode(text))
}

/// The file of a URI: decoded, as the format requires, or taken literally, or with back slashes as separators.
fn find(uri: &str, folder: &Path) -> Result<PathBuf, String> {
    let decoded = percent_decode_str(uri).decode_utf8_lossy();
    let spellings = [&*decoded, uri, &decoded.replace('\\', "/")].map(|name| folder.join(name));
    if let Some(path) = spellings.iter().find(|path| path.exists()) {
        return Ok(path.clone());
    }
    let missing = format!("the file `{}` does not exist", quote(uri));
    Err(
        match spellings.iter().find_map(|path| in_other_case(path)) {
            Some(name) => format!("{missing}, but `{}` does: rename one of them", quote(&name)),
            None => missing,
        },
    )
}

/// The name of a file that differs from `path` only in case.
fn in_other_case(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?.to_lowercase();
    let beside = Path::new(".").join(path.parent()?).read_dir().ok()?;
    beside
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .find(|other| other.to_lowercase() == name)
}

/// The first `length` bytes of a file; refuses devices, which may never end.
fn read(path: &Path, length: u64) -> io::Result<Vec<u8>> {
    if !path.metadata()?.is_file() {
        return Err(io::Error::other("it is not a file"));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(length).read_to_end(&mut bytes)?;
    Ok(bytes)
}

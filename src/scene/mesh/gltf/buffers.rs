//! A document's buffers: the chunk of a GLB, files beside the document, data within it.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use gltf::json::{Buffer, Root};
use percent_encoding::percent_decode_str;

use crate::scene::text::quote;

const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The bytes of each buffer, no fewer than it claims, and the files that they are from; an error says what is wrong.
pub(super) fn load<'a>(
    root: &Root,
    bin: Option<&'a [u8]>,
    folder: &Path,
) -> Result<(Vec<Cow<'a, [u8]>>, Vec<PathBuf>), String> {
    let mut files = Vec::new();
    let load = |(number, buffer): (usize, &Buffer)| {
        let bytes = match &buffer.uri {
            Some(uri) => at(uri, buffer.byte_length.0, folder, &mut files).map(Cow::Owned),
            None => bin
                .map(Cow::Borrowed)
                .ok_or_else(|| "there is no binary chunk".into()),
        };
        match bytes {
            Ok(bytes) if bytes.len() as u64 >= buffer.byte_length.0 => Ok(bytes),
            Ok(bytes) => Err(format!(
                "its buffer {number} is truncated: it claims {} bytes, and has {}",
                buffer.byte_length.0,
                bytes.len()
            )),
            Err(reason) => Err(format!("its buffer {number} cannot be read: {reason}")),
        }
    };
    let bytes = root.buffers.iter().enumerate().map(load);
    Ok((bytes.collect::<Result<_, _>>()?, files))
}

/// What stands at a URI: `data:…;base64,…`, or the first `length` bytes of a file relative to `folder`, which joins
/// `files`.
fn at(uri: &str, length: u64, folder: &Path, files: &mut Vec<PathBuf>) -> Result<Vec<u8>, String> {
    let quoted = quote(uri);
    if let Some(data) = uri.strip_prefix("data:") {
        let Some((_, text)) = data.split_once(";base64,") else {
            return Err(format!("`{quoted}` is not in base64"));
        };
        return BASE64.decode(text).map_err(|error| error.to_string());
    }
    // A colon in a relative reference must be encoded: this is a scheme.
    if uri.contains(':') {
        return Err(format!("`{quoted}` is no file beside it"));
    }
    let path = folder.join(&*percent_decode_str(uri).decode_utf8_lossy());
    let bytes = file(&path, length).map_err(|reason| match reason.kind() {
        io::ErrorKind::NotFound => format!("there is no file `{quoted}`"),
        _ => format!("`{quoted}`: {reason}"),
    })?;
    files.push(path);
    Ok(bytes)
}

/// The first `length` bytes of a file; not of a device, which may never end.
fn file(path: &Path, length: u64) -> io::Result<Vec<u8>> {
    if !path.metadata()?.is_file() {
        return Err(io::Error::other("it is no file"));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(length).read_to_end(&mut bytes)?;
    Ok(bytes)
}

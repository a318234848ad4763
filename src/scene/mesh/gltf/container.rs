//! A document's JSON, alone or in a GLB (glTF 2.0, section 4, *GLB File Format Specification*). The bytes decide, not
//! the file's extension.

use std::borrow::Cow;

/// The JSON of a document, and the binary chunk of a GLB, if any.
pub(super) struct Container<'a> {
    pub(super) json: Cow<'a, str>,
    pub(super) bin: Option<&'a [u8]>,
}

/// Parses the file `bytes`. Errors are messages.
pub(super) fn open(bytes: &[u8]) -> Result<Container<'_>, String> {
    let (json, bin) = match bytes.starts_with(b"glTF") {
        true => chunks(bytes)?,
        false => (bytes, None),
    };
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    // A GLB's JSON is padded; exporters that violate the format pad with zeros.
    let padding = |b: &u8| *b == 0 || b.is_ascii_whitespace();
    let end = json
        .iter()
        .rposition(|b| !padding(b))
        .map_or(0, |last| last + 1);
    Ok(Container {
        // Names in another encoding do not make a mesh unreadable.
        json: String::from_utf8_lossy(&json[..end]),
        bin,
    })
}

/// The JSON of a GLB and its first binary chunk; unknown chunks are skipped.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    // Magic number, version, length of the file.
    let word = |at: usize| bytes.get(at..)?.first_chunk().copied();
    let [version, claimed] = [4, 8].map(|at| word(at).map_or(0, u32::from_le_bytes));
    if bytes.len() >= 12 && version != 2 {
        return Err(format!(
            "it is glTF {version}.0, but only 2.0 is supported: convert it"
        ));
    }
    let body = bytes.get(12..claimed as usize).ok_or_else(|| {
        let has = bytes.len();
        format!("it is truncated: it declares {claimed} bytes, but has {has}")
    })?;
    let json = chunk(body)?;
    if json.kind != b"JSON" {
        return Err("its first chunk is not JSON".into());
    }
    let mut rest = json.rest;
    while !rest.is_empty() {
        let next = chunk(rest)?;
        if next.kind == b"BIN\0" {
            return Ok((json.content, Some(next.content)));
        }
        rest = next.rest;
    }
    Ok((json.content, None))
}

struct Chunk<'a> {
    kind: &'a [u8; 4],
    content: &'a [u8],
    /// The bytes after the chunk.
    rest: &'a [u8],
}

/// Splits the first chunk off `bytes`.
fn chunk(bytes: &[u8]) -> Result<Chunk<'_>, String> {
    let header = bytes
        .split_first_chunk()
        .and_then(|(length, rest)| Some((u32::from_le_bytes(*length), rest.split_first_chunk()?)));
    let (claimed, (kind, rest)) = header.ok_or("it is truncated within the header of a chunk")?;
    let split = rest.split_at_checked(claimed as usize);
    let (content, rest) = split.ok_or_else(|| {
        let has = rest.len();
        format!("it is truncated: a chunk declares {claimed} bytes, but {has} follow")
    })?;
    Ok(Chunk {
        kind,
        content,
        rest,
    })
}

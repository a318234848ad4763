//! Reads pictures of any program: linear RGB, position of the pixels, and rounding.

mod error;
mod exr;
mod hdr;
mod png;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

pub use error::{DecodeError, ReadError};

use super::{Format, Precision};
use crate::film::Film;

/// The largest picture that is read: 16384² pixels, 3 GiB.
const MOST_PIXELS: u64 = 1 << 28;

/// Maximum compression factor of a file. Black pixels compress best: deflate (RFC 1951) makes one byte of 1032, and
/// EXR's DWA does so with one value out of 64.
const MOST_SHORTENED: u64 = 1 << 17;

/// A picture as stored in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The stored pixels, all finite. Negative values are legal: other renderers filter.
    pub film: Film,
    /// Column and row of the film's top left pixel in the full picture; [0, 0] but for an EXR's data window.
    pub origin: [i32; 2],
    /// Width and height of the full picture: the film's, or those of an EXR's display window.
    pub full: [u32; 2],
    pub precision: Precision,
    /// The file's description of itself: an EXR's `comments`, where vkpt writes how the picture was made.
    pub notes: String,
}

impl Picture {
    /// A film that covers the full picture.
    fn whole(film: Film, precision: Precision) -> Self {
        let full = [film.width, film.height];
        Self {
            film,
            origin: [0, 0],
            full,
            precision,
            notes: String::new(),
        }
    }
}

/// Reads an EXR, an HDR or a PNG, identified by its first bytes; see [`decode`].
pub fn read(path: &Path) -> Result<Picture, ReadError> {
    read_as(path, decode)
}

fn read_as(
    path: &Path,
    decode: impl Fn(&[u8]) -> Result<Picture, DecodeError>,
) -> Result<Picture, ReadError> {
    let picture = || {
        let metadata = fs::metadata(path)?;
        if metadata.is_dir() {
            return Err(DecodeError::Folder);
        }
        if !metadata.is_file() {
            return Err(DecodeError::NoFile);
        }
        decode(&fs::read(path)?)
    };
    picture().map_err(|cause| ReadError {
        path: path.to_owned(),
        cause,
    })
}

/// Reads a layer of an EXR like [`read`]: NAME.R, G and B, NAME.X, Y and Z, or the single channel NAME, which is then
/// used for all three.
pub fn read_layer(path: &Path, layer: &str) -> Result<Picture, ReadError> {
    read_as(path, |bytes| decode_layer(bytes, layer))
}

/// Decodes a picture from a file's bytes.
///
/// EXR: flat, any of the compressions but HTJ2K, scan lines or tiles (the finest level), half or float. R, G and B are
/// those of the first part that has them; otherwise those of the only layer (`color.R` …) that does. HDR: RGBE with the
/// rows from the top; `EXPOSURE` is undone. PNG: 1 to 16 bits, grey, palette or RGB, as sRGB codes. Alpha and all other
/// channels are ignored. Primaries other than sRGB's are refused, and so is a PNG that declares that its codes are not
/// sRGB.
pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    if bytes.is_empty() {
        return Err(DecodeError::Empty);
    }
    let decode = match Format::of_bytes(bytes).ok_or(DecodeError::Unknown)? {
        Format::Exr => exr::decode,
        Format::Hdr => hdr::decode,
        Format::Png => png::decode,
    };
    checked(|| decode(bytes))
}

/// Decodes a layer from the bytes of an EXR, see [`read_layer`].
fn decode_layer(bytes: &[u8], layer: &str) -> Result<Picture, DecodeError> {
    match Format::of_bytes(bytes) {
        Some(Format::Exr) => checked(|| exr::decode_layer(bytes, layer)),
        _ => Err(DecodeError::NoLayers),
    }
}

/// Runs a decoder and checks its result.
fn checked(decode: impl Fn() -> Result<Picture, DecodeError>) -> Result<Picture, DecodeError> {
    // The crates are hardened against broken files, but not proved to be.
    let picture = catch_unwind(AssertUnwindSafe(decode))
        .unwrap_or(Err(DecodeError::Broken("its decoder failed".to_owned())))
        .map_err(DecodeError::printable)?;
    check_finite(&picture)?;
    Ok(picture)
}

/// The number of pixels of a picture: at least one, and no more than the file can contain.
fn pixels(
    width: u64,
    height: u64,
    bytes_per_pixel: u64,
    file: &[u8],
) -> Result<usize, DecodeError> {
    let pixels = width.saturating_mul(height);
    let bytes = file.len() as u64;
    match pixels {
        0 => Err(DecodeError::NoPixels),
        _ if pixels > MOST_PIXELS => Err(DecodeError::TooLarge { width, height }),
        _ if pixels.saturating_mul(bytes_per_pixel) > bytes.saturating_mul(MOST_SHORTENED) => {
            Err(DecodeError::Lying {
                width,
                height,
                bytes,
            })
        }
        // At most 2²⁸.
        _ => Ok(pixels as usize),
    }
}

/// Refuses NaN and infinity: every mean over the picture would be one.
fn check_finite(picture: &Picture) -> Result<(), DecodeError> {
    let values = picture.film.rgb.as_flattened();
    let mut bad = values.iter().enumerate().filter(|(_, v)| !v.is_finite());
    let Some((index, &value)) = bad.next() else {
        return Ok(());
    };
    let (column, row) = (
        index / 3 % picture.film.width as usize,
        index / 3 / picture.film.width as usize,
    );
    Err(DecodeError::NotFinite {
        count: 1 + bad.count(),
        value,
        x: i64::from(picture.origin[0]) + column as i64,
        y: i64::from(picture.origin[1]) + row as i64,
        channel: ['R', 'G', 'B'][index % 3],
    })
}

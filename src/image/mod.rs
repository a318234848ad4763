//! Reads and writes pictures; files appear whole or not at all.

pub mod claim;
pub mod file;
pub mod place;
mod precision;
mod primaries;
mod read;
pub mod rgbe;
pub mod srgb;
pub mod straight;
mod write;

pub use precision::Precision;
pub use read::{DecodeError, Picture, ReadError, decode, read, read_layer};
pub use write::{EncodeError, Frame, Labels, encode};

use std::path::Path;

/// A file format for pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 bit sRGB.
    Png,
    /// Linear RGB in bytes with a common exponent.
    Hdr,
    /// Linear f32 RGB.
    Exr,
}

impl Format {
    /// The format of a file's extension, in any case.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?;
        match () {
            () if ending.eq_ignore_ascii_case("png") => Some(Self::Png),
            () if ending.eq_ignore_ascii_case("hdr") => Some(Self::Hdr),
            () if ending.eq_ignore_ascii_case("exr") => Some(Self::Exr),
            () => None,
        }
    }

    /// The format given by a file's first bytes, regardless of its name.
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        // Radiance writes the first, other programs the second.
        let hdr: [&[u8]; 2] = [b"#?RADIANCE", b"#?RGBE"];
        match () {
            () if bytes.starts_with(b"\x89PNG\r\n\x1a\n") => Some(Self::Png),
            () if hdr.iter().any(|magic| bytes.starts_with(magic)) => Some(Self::Hdr),
            () if bytes.starts_with(b"\x76\x2f\x31\x01") => Some(Self::Exr),
            () => None,
        }
    }
}

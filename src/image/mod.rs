//! Pictures: a film as a PNG to look at or an EXR to compute with, and files that appear whole or not at all.

mod exr;
pub mod file;
mod png;
pub mod srgb;

use std::io::{Seek, Write};
use std::path::Path;

use crate::film::Film;

/// A film and its place in the full picture.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    pub film: &'a Film,
    /// Column and row of the film's top left pixel in the full picture.
    pub origin: [u32; 2],
    /// Width and height of the full picture.
    pub full: [u32; 2],
}

/// What is told beside the pixels.
#[derive(Clone, Copy, Debug)]
pub struct Labels<'a> {
    /// PNG only: stops by which radiance is scaled before it is mapped; EXR keeps radiance as it is.
    pub exposure: f64,
    /// EXR only: the program and its version.
    pub software: &'a str,
    /// EXR only: names and values for the header's `comments`, a line each. Must not change from run to run.
    pub notes: &'a [(&'static str, String)],
}

/// A file format for pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 bit sRGB.
    Png,
    /// Linear f32 RGB.
    Exr,
}

impl Format {
    /// The format that a file's ending asks for, in upper or lower case.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?;
        match () {
            () if ending.eq_ignore_ascii_case("png") => Some(Self::Png),
            () if ending.eq_ignore_ascii_case("exr") => Some(Self::Exr),
            () => None,
        }
    }
}

/// Why a picture could not be encoded.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    #[error("{0}")]
    Png(#[from] ::png::EncodingError),
    #[error("{0}")]
    Exr(#[from] ::exr::error::Error),
    #[error("the picture is {width}×{height} pixels, but its film holds {pixels}")]
    Size {
        width: u32,
        height: u32,
        pixels: usize,
    },
}

/// Writes the frame in the format. Equal input gives equal bytes.
pub fn encode(
    frame: &Frame,
    format: Format,
    labels: &Labels,
    out: &mut (impl Write + Seek),
) -> Result<(), EncodeError> {
    let Film {
        width,
        height,
        ref rgb,
    } = *frame.film;
    if u64::from(width) * u64::from(height) != rgb.len() as u64 {
        return Err(EncodeError::Size {
            width,
            height,
            pixels: rgb.len(),
        });
    }
    match format {
        Format::Png => png::encode(frame.film, labels.exposure, out),
        Format::Exr => exr::encode(frame, labels, out),
    }
}

//! Writes a film as a PNG for viewing, an HDR for lighting or an EXR for computing.

mod exr;
mod hdr;
mod png;

use std::io::{Seek, Write};

use super::Format;
use crate::film::{Channel, Film};

/// A film and its place in the full picture.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    pub film: &'a Film,
    /// Column and row of the film's top left pixel in the full picture.
    pub origin: [u32; 2],
    /// Width and height of the full picture.
    pub full: [u32; 2],
    /// EXR only: further channels, one value per pixel of the film.
    pub channels: &'a [Channel],
}

impl<'a> Frame<'a> {
    /// A film that covers the full picture, without further channels.
    pub fn whole(film: &'a Film) -> Self {
        Self {
            film,
            origin: [0, 0],
            full: [film.width, film.height],
            channels: &[],
        }
    }
}

/// Metadata and settings of a picture file.
#[derive(Clone, Copy, Debug)]
pub struct Labels<'a> {
    /// PNG only: stops by which radiance is scaled before the mapping; EXR and HDR keep radiance unchanged.
    pub exposure: f64,
    /// EXR only: the program and its version.
    pub software: &'a str,
    /// EXR only: names and values for the header's `comments`, one per line. Must not change from run to run.
    pub notes: &'a [(&'static str, String)],
}

/// Errors in encoding a picture.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    #[error("{0}")]
    Png(#[from] ::png::EncodingError),
    #[error("{0}")]
    Hdr(#[from] ::image::ImageError),
    #[error("{0}")]
    Exr(#[from] ::exr::error::Error),
    #[error("the picture is {width}×{height} pixels, but its film has {pixels}")]
    Size {
        width: u32,
        height: u32,
        pixels: usize,
    },
}

/// Writes the frame in the format. Equal input gives equal bytes. Only EXR stores the film's place in the full picture;
/// PNG and HDR store only the film.
pub fn encode(
    frame: &Frame,
    format: Format,
    labels: &Labels,
    out: &mut (impl Write + Seek + ?Sized),
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
        Format::Hdr => hdr::encode(frame.film, out),
        Format::Exr => exr::encode(frame, labels, out),
    }
}

//! OpenEXR: the R, G and B of one layer, placed at its data window.

mod blocks;
mod channels;
mod dwa;

use std::io::Cursor;

use ::exr::block::reader::Reader;
use ::exr::compression::Compression;
use ::exr::error::Error;
use ::exr::math::Vec2;
use ::exr::meta::attribute::{Chromaticities, SampleType};
use ::exr::meta::header::Header;

use super::{DecodeError, Picture, pixels};
use crate::film::Film;
use crate::image::{Precision, primaries};
use channels::Rgb;

/// Decodes R, G and B.
pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    chosen(bytes, channels::choose)
}

/// Decodes the channels of a layer.
pub fn decode_layer(bytes: &[u8], layer: &str) -> Result<Picture, DecodeError> {
    chosen(bytes, |headers| channels::layer(headers, layer))
}

fn chosen(
    bytes: &[u8],
    choose: impl Fn(&[Header]) -> Result<Rgb, DecodeError>,
) -> Result<Picture, DecodeError> {
    // Bit 11 of the version field, the file's second word.
    if bytes.get(5).is_some_and(|flags| flags & 0b1000 != 0) {
        let deep = "deep data, which has several values per pixel";
        return Err(DecodeError::Unsupported(deep.to_owned()));
    }
    let reader = Reader::read_from_buffered(Cursor::new(bytes), false)?;
    let meta = reader.meta_data().clone();
    let rgb = choose(&meta.headers)?;
    let header = &meta.headers[rgb.part];
    check_primaries(header.shared_attributes.chromaticities)?;
    let precision = precision(header, &rgb)?;

    let Vec2(width, height) = header.layer_size;
    let bytes_per_pixel = header.channels.bytes_per_pixel as u64;
    let pixels = pixels(width as u64, height as u64, bytes_per_pixel, bytes)?;
    let mut film = Film {
        width: side(width)?,
        height: side(height)?,
        rgb: vec![[0.0; 3]; pixels],
    };
    blocks::fill(&mut film, reader, &meta, &rgb)?;

    let window = header.shared_attributes.display_window;
    let place = |data: i32, display: i32| {
        data.checked_sub(display)
            .ok_or_else(|| broken("its data window is too far from the origin"))
    };
    let position = header.own_attributes.layer_position;
    let comments = header.own_attributes.comments.as_ref();
    Ok(Picture {
        film,
        origin: [
            place(position.x(), window.position.x())?,
            place(position.y(), window.position.y())?,
        ],
        full: [side(window.size.width())?, side(window.size.height())?],
        precision,
        notes: comments.map(ToString::to_string).unwrap_or_default(),
    })
}

fn broken(why: &str) -> DecodeError {
    DecodeError::Broken(why.to_owned())
}

fn side(pixels: usize) -> Result<u32, DecodeError> {
    u32::try_from(pixels).map_err(|_| broken("a side of 2³² pixels"))
}

/// By the standard, a missing attribute means BT.709.
fn check_primaries(given: Option<Chromaticities>) -> Result<(), DecodeError> {
    let xy = |Vec2(x, y): Vec2<f32>| [f64::from(x), f64::from(y)];
    match given {
        Some(c) if !primaries::are_srgb([c.red, c.green, c.blue, c.white].map(xy)) => Err(
            DecodeError::Colours("its `chromaticities` differ".to_owned()),
        ),
        _ => Ok(()),
    }
}

/// The precision of the coarsest of the three channels.
fn precision(header: &Header, rgb: &Rgb) -> Result<Precision, DecodeError> {
    let mut coarsest = Precision::Single;
    for channel in rgb.channels.map(|index| &header.channels.list[index]) {
        let stored = match channel.sample_type {
            SampleType::U32 => {
                let channel = channel.name.to_string();
                return Err(DecodeError::WholeNumbers { channel });
            }
            kind if header.compression.is_lossless_for(kind) => match kind {
                SampleType::F16 => Precision::Half,
                _ => Precision::Single,
            },
            _ if header.compression == Compression::PXR24 => Precision::Pxr24,
            _ => Precision::Lossy,
        };
        coarsest = coarsest.coarser(stored);
    }
    Ok(coarsest)
}

impl From<Error> for DecodeError {
    fn from(error: Error) -> Self {
        match error {
            Error::NotSupported(what) => Self::Unsupported(what.into_owned()),
            Error::Invalid(what) => Self::Broken(what.into_owned()),
            error => Self::Broken(error.to_string()),
        }
    }
}

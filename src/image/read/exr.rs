//! OpenEXR: the R, G and B of one layer, at the place of its data window.

mod channels;

use std::collections::HashSet;
use std::io::Cursor;

use ::exr::block::UncompressedBlock;
use ::exr::block::lines::LineRef;
use ::exr::block::reader::{ChunksReader, Reader};
use ::exr::compression::Compression;
use ::exr::error::Error;
use ::exr::math::Vec2;
use ::exr::meta::attribute::{Chromaticities, SampleType};
use ::exr::meta::header::Header;
use ::exr::prelude::f16;

use super::{DecodeError, Picture, pixels};
use crate::film::Film;
use crate::image::{Precision, primaries};
use channels::Rgb;

pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    // Bit 11 of the version field, the file's second word.
    if bytes.get(5).is_some_and(|flags| flags & 0b1000 != 0) {
        let deep = "deep data, which has several values a pixel";
        return Err(DecodeError::Unsupported(deep.to_owned()));
    }
    let reader = Reader::read_from_buffered(Cursor::new(bytes), false)?;
    let rgb = channels::choose(reader.headers())?;
    let header = reader.headers()[rgb.part].clone();
    check_primaries(header.shared_attributes.chromaticities)?;
    let precision = precision(&header, &rgb)?;

    let Vec2(width, height) = header.layer_size;
    let pixels = pixels(width as u64, height as u64, bytes)?;
    let mut film = Film {
        width: side(width)?,
        height: side(height)?,
        rgb: vec![[0.0; 3]; pixels],
    };
    fill(&mut film, reader, &rgb)?;

    let window = header.shared_attributes.display_window;
    let place = |data: i32, display: i32| {
        data.checked_sub(display)
            .ok_or_else(|| broken("its data window is too far away"))
    };
    let position = header.own_attributes.layer_position;
    Ok(Picture {
        film,
        origin: [
            place(position.x(), window.position.x())?,
            place(position.y(), window.position.y())?,
        ],
        full: [side(window.size.width())?, side(window.size.height())?],
        precision,
    })
}

fn broken(why: &str) -> DecodeError {
    DecodeError::Broken(why.to_owned())
}

fn side(pixels: usize) -> Result<u32, DecodeError> {
    u32::try_from(pixels).map_err(|_| broken("a side of 2³² pixels"))
}

/// Without the attribute, the standard says, it is BT.709's.
fn check_primaries(given: Option<Chromaticities>) -> Result<(), DecodeError> {
    let xy = |Vec2(x, y): Vec2<f32>| [f64::from(x), f64::from(y)];
    match given {
        Some(c) if !primaries::are_srgb([c.red, c.green, c.blue, c.white].map(xy)) => Err(
            DecodeError::Colours("its `chromaticities` are others".to_owned()),
        ),
        _ => Ok(()),
    }
}

/// That of the coarsest of the three channels.
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

/// Copies the blocks of the part's finest level into the film; each must be there once.
fn fill(film: &mut Film, reader: Reader<Cursor<&[u8]>>, rgb: &Rgb) -> Result<(), Error> {
    let mut awaited = HashSet::new();
    let chunks = reader.filter_chunks(false, |_, _, block| {
        let wanted = block.layer == rgb.part && block.level == Vec2(0, 0);
        wanted && awaited.insert(block)
    })?;
    chunks.decompress_sequential(false, |meta, block| {
        if !awaited.remove(&block.index) {
            return Err(Error::Invalid(
                "blocks other than its header tells of".into(),
            ));
        }
        copy(film, &block, &meta.headers[rgb.part], rgb)
    })?;
    match awaited.len() {
        0 => Ok(()),
        _ => Err(Error::Invalid("blocks are missing".into())),
    }
}

/// A block stores a row of each channel after the other.
fn copy(
    film: &mut Film,
    block: &UncompressedBlock,
    header: &Header,
    rgb: &Rgb,
) -> Result<(), Error> {
    for line in block.lines(&header.channels) {
        let channel = line.location.channel;
        if let Some(component) = rgb.channels.iter().position(|&c| c == channel) {
            let Vec2(x, y) = line.location.position;
            let start = y * film.width as usize + x;
            let row = &mut film.rgb[start..start + line.location.sample_count];
            for (pixel, value) in row.iter_mut().zip(samples(&line, header)?) {
                pixel[component] = value;
            }
        }
    }
    Ok(())
}

fn samples(line: &LineRef, header: &Header) -> Result<Vec<f32>, Error> {
    match header.channels.list[line.location.channel].sample_type {
        SampleType::F16 => line
            .read_samples::<f16>()
            .map(|sample| sample.map(f16::to_f32))
            .collect(),
        _ => line.read_samples::<f32>().collect(),
    }
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

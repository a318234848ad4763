//! Copies the blocks of an EXR into a film.

use std::collections::HashSet;
use std::io::Cursor;

use ::exr::block::UncompressedBlock;
use ::exr::block::lines::LineRef;
use ::exr::block::reader::Reader;
use ::exr::error::Error;
use ::exr::math::Vec2;
use ::exr::meta::MetaData;
use ::exr::meta::attribute::SampleType;
use ::exr::meta::header::Header;
use ::exr::prelude::f16;

use super::channels::Rgb;
use super::dwa;
use crate::film::Film;

/// Copies the blocks of the part's finest level into the film. As many chunks are read as blocks are expected, and no
/// block may occur twice, so all of them are present.
pub fn fill(
    film: &mut Film,
    reader: Reader<Cursor<&[u8]>>,
    meta: &MetaData,
    rgb: &Rgb,
) -> Result<(), Error> {
    let header = &meta.headers[rgb.part];
    let mut awaited = HashSet::new();
    let chunks = reader.filter_chunks(false, |_, _, block| {
        let wanted = block.layer == rgb.part && block.level == Vec2(0, 0);
        wanted && awaited.insert(block)
    })?;
    let stray = || Error::Invalid("its blocks do not match its header".into());
    for chunk in chunks {
        let chunk = chunk?;
        if chunk.layer_index != rgb.part {
            return Err(stray());
        }
        dwa::check(&chunk, header)?;
        let block = UncompressedBlock::decompress_chunk(chunk, meta, false)?;
        if !awaited.remove(&block.index) {
            return Err(stray());
        }
        copy(film, &block, header, rgb)?;
    }
    Ok(())
}

/// A block stores one row after another, each channel by channel.
fn copy(
    film: &mut Film,
    block: &UncompressedBlock,
    header: &Header,
    rgb: &Rgb,
) -> Result<(), Error> {
    for line in block.lines(&header.channels) {
        let channel = line.location.channel;
        // The channel of a single-channel layer fills all three places.
        let places = |&i: &usize| rgb.channels[i] == channel;
        for component in (0..3).filter(places) {
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

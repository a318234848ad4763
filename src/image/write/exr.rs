//! OpenEXR: linear f32 RGB, with the origin of the picture in its header.

use std::io::{Seek, SeekFrom, Write};

use ::exr::prelude::*;

use super::{EncodeError, Frame, Labels};

/// Writes the film. Its data window is the frame's place in the display window, which is the full picture.
///
/// The notes share the standard attribute `comments`: the crate keeps custom attributes in a hash map and writes them
/// in an order that changes from run to run.
pub fn encode(
    frame: &Frame,
    labels: &Labels,
    out: &mut (impl Write + Seek + ?Sized),
) -> std::result::Result<(), EncodeError> {
    let film = frame.film;
    let (width, height) = (film.width as usize, film.height as usize);
    let attributes = LayerAttributes {
        software_name: Some(text(labels.software)),
        comments: Some(text(&lines(labels.notes))),
        layer_position: Vec2(frame.origin[0] as i32, frame.origin[1] as i32),
        ..LayerAttributes::default()
    };
    let full = IntegerBounds::from_dimensions((frame.full[0] as usize, frame.full[1] as usize));
    let size = (width, height);
    if frame.channels.is_empty() {
        let pixels = SpecificChannels::rgb(|Vec2(x, y): Vec2<usize>| {
            let [r, g, b] = film.rgb[y * width + x];
            (r, g, b)
        });
        let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, pixels);
        let mut image = Image::from_layer(layer);
        image.attributes.display_window = full;
        return Ok(image.write().to_buffered(out)?);
    }
    let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, all(frame));
    let mut image = Image::from_layer(layer);
    image.attributes.display_window = full;
    let begin = out.stream_position().map_err(::exr::error::Error::from)?;
    image.write().to_buffered(&mut *out)?;
    match frame.channels.iter().any(|c| c.name.len() > SHORT_NAME) {
        true => Ok(flag_long_names(begin, out)?),
        false => Ok(()),
    }
}

/// Sets the flag for long names in a file that begins at `begin`, which the crate omits. No other flag is set in a file
/// with one layer of scan lines.
fn flag_long_names(begin: u64, out: &mut (impl Write + Seek + ?Sized)) -> ::exr::error::UnitResult {
    out.seek(SeekFrom::Start(begin + FLAGS))?;
    out.write_all(&[LONG_NAMES])?;
    out.seek(SeekFrom::End(0))?;
    Ok(())
}

/// Length in bytes of a name that any reader accepts.
const SHORT_NAME: usize = 31;
/// Position of the flags in the version field, and the flag for names of up to 255 bytes, bit 10 of that field (OpenEXR
/// File Layout, "Version Field").
const FLAGS: u64 = 5;
const LONG_NAMES: u8 = 4;

/// R, G, B and the additional channels, sorted by name as the format requires.
fn all(frame: &Frame) -> AnyChannels<FlatSamples> {
    let channel = |name: &str, values| AnyChannel::new(name, FlatSamples::F32(values));
    let of_film = |(i, name)| channel(name, frame.film.rgb.iter().map(|rgb| rgb[i]).collect());
    let film = ["R", "G", "B"].into_iter().enumerate().map(of_film);
    let beside = frame
        .channels
        .iter()
        .map(|c| channel(&c.name, c.values.clone()));
    AnyChannels::sort(film.chain(beside).collect())
}

fn lines(notes: &[(&'static str, String)]) -> String {
    notes
        .iter()
        .map(|(name, value)| format!("{name}: {value}\n"))
        .collect()
}

/// UTF-8 unchanged: the format prescribes no encoding.
fn text(s: &str) -> Text {
    Text::from_bytes_unchecked(s.bytes().collect())
}

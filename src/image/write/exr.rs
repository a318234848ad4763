//! OpenEXR: linear f32 RGB, with what the picture was made from in its header.

use std::io::{Seek, Write};

use ::exr::prelude::*;

use super::{EncodeError, Frame, Labels};

/// Writes the film; its data window is the frame's place in the display window, the full picture.
///
/// The notes share the standard attribute `comments`: the crate keeps attributes of one's own in a hash map
/// and writes them in an order that changes from run to run.
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
    let pixels = SpecificChannels::rgb(|Vec2(x, y): Vec2<usize>| {
        let [r, g, b] = film.rgb[y * width + x];
        (r, g, b)
    });
    let layer = Layer::new(
        (width, height),
        attributes,
        Encoding::SMALL_LOSSLESS,
        pixels,
    );
    let mut image = Image::from_layer(layer);
    image.attributes.display_window =
        IntegerBounds::from_dimensions((frame.full[0] as usize, frame.full[1] as usize));
    Ok(image.write().to_buffered(out)?)
}

fn lines(notes: &[(&'static str, String)]) -> String {
    notes
        .iter()
        .map(|(name, value)| format!("{name}: {value}\n"))
        .collect()
}

/// UTF-8 as it stands: the format prescribes no encoding.
fn text(s: &str) -> Text {
    Text::from_bytes_unchecked(s.bytes().collect())
}

//! Pictures inside a page.

use std::io::Cursor;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

use vkpt::film::Film;
use vkpt::image::{EncodeError, Format, Frame, Labels, encode};
use vkpt::report::SOFTWARE;

/// The film × 2^`exposure` as a PNG (8-bit sRGB), in a `data:` address: about 4 bytes of text for 3 of the PNG, which of a
/// noisy picture are hardly fewer than its 3 bytes a pixel.
///
/// # Errors
/// A film that holds more or fewer pixels than it says.
pub fn data_uri(film: &Film, exposure: f64) -> Result<String, EncodeError> {
    let labels = Labels {
        exposure,
        software: SOFTWARE,
        notes: &[],
    };
    let mut png = Cursor::new(Vec::new());
    encode(&Frame::whole(film), Format::Png, &labels, &mut png)?;
    let text = STANDARD.encode(png.into_inner());
    Ok(format!("data:image/png;base64,{text}"))
}

/// The film as [`data_uri`] has it, with words for those who don't see it.
///
/// # Errors
/// As [`data_uri`].
pub fn image(film: &Film, exposure: f64, alt: &str) -> Result<Markup, EncodeError> {
    let source = data_uri(film, exposure)?;
    Ok(html! {
        img src=(source) alt=(alt) width=(film.width) height=(film.height) decoding="async";
    })
}

//! Pictures inside a page.

use std::io::Cursor;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

use vkpt::film::Film;
use vkpt::image::{EncodeError, Format, Frame, Labels, encode};
use vkpt::report::SOFTWARE;

/// The film × 2^`exposure` as a PNG (8-bit sRGB), in a `data:` address: about 4 bytes of text for 3 of the PNG, which for a
/// noisy picture is hardly less than 3 bytes per pixel.
///
/// # Errors
/// A film with more or fewer pixels than its size.
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

/// The film as in [`data_uri`], with alternative text.
///
/// # Errors
/// As [`data_uri`].
pub fn image(film: &Film, exposure: f64, alt: &str) -> Result<Markup, EncodeError> {
    let source = data_uri(film, exposure)?;
    Ok(html! {
        img src=(source) alt=(alt) width=(film.width) height=(film.height) decoding="async";
    })
}

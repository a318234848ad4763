//! Radiance HDR: linear RGB in four bytes per pixel.

use std::io::Write;

use ::image::Rgb;
use ::image::codecs::hdr::HdrEncoder;

use super::EncodeError;
use crate::film::Film;
use crate::image::rgbe;

/// Writes the film, each pixel rounded to the nearest in the format.
///
/// The crate's encoder truncates, and wraps the exponent of values that are too large or too small; here it receives
/// pixels of the format, which it preserves exactly.
pub fn encode(film: &Film, out: &mut (impl Write + ?Sized)) -> Result<(), EncodeError> {
    let pixels: Vec<_> = film.rgb.iter().map(|&p| Rgb(rgbe::nearest(p))).collect();
    let (width, height) = (film.width as usize, film.height as usize);
    Ok(HdrEncoder::new(out).encode(&pixels, width, height)?)
}

//! Radiance HDR: linear RGB in four bytes a pixel.

use std::io::Write;

use ::image::Rgb;
use ::image::codecs::hdr::HdrEncoder;

use super::EncodeError;
use crate::film::Film;
use crate::image::rgbe;

/// Writes the film, each pixel rounded to the nearest that the format holds.
///
/// The crate's encoder truncates, and wraps the exponent of what is too large or too small; what it is given here
/// is already a pixel of the format, which it keeps to the bit.
pub fn encode(film: &Film, out: &mut (impl Write + ?Sized)) -> Result<(), EncodeError> {
    let pixels: Vec<_> = film.rgb.iter().map(|&p| Rgb(rgbe::nearest(p))).collect();
    let (width, height) = (film.width as usize, film.height as usize);
    Ok(HdrEncoder::new(out).encode(&pixels, width, height)?)
}

//! PNG: 8-bit sRGB, for viewing.

use std::io::Write;

use super::EncodeError;
use crate::film::Film;
use crate::image::srgb;

/// Writes the film × 2^`exposure`, clamped, with the sRGB transfer.
pub fn encode(
    film: &Film,
    exposure: f64,
    out: &mut (impl Write + ?Sized),
) -> Result<(), EncodeError> {
    let scale = exposure.exp2();
    let bytes: Vec<u8> = film
        .rgb
        .iter()
        .flatten()
        .map(|&radiance| srgb::quantise(f64::from(radiance) * scale))
        .collect();
    let mut encoder = ::png::Encoder::new(out, film.width, film.height);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_source_srgb(::png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    Ok(writer.finish()?)
}

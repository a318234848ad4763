//! PNG: sRGB codes of 1 to 16 bits, converted to linear.

use std::io::Cursor;

use ::png::{BitDepth, ColorType, Decoder, DecodingError, Info, Transformations};

use super::{DecodeError, Picture, pixels};
use crate::film::Film;
use crate::image::{Precision, primaries, srgb};

pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    // Palettes become RGB; codes of fewer than 8 bits are scaled to 255.
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    let mut reader = decoder.read_info()?;
    let info = reader.info();
    check_colours(info)?;
    let (width, height) = (info.width, info.height);
    let precision = Precision::Srgb { bits: bits(info) };

    let bytes_per_pixel = info.bytes_per_pixel() as u64;
    let pixels = pixels(width.into(), height.into(), bytes_per_pixel, bytes)?;
    let (colour, depth) = reader.output_color_type();
    let wide = depth == BitDepth::Sixteen;
    let mut codes = vec![0; pixels * colour.samples() * if wide { 2 } else { 1 }];
    reader.next_frame(&mut codes)?;
    reader.finish()?;

    let rgb = if wide {
        let codes = codes.as_chunks().0.iter();
        let linear = |&code: &[u8; 2]| f64::from(u16::from_be_bytes(code)) / 65535.0;
        film(codes.map(linear), colour)
    } else {
        film(codes.iter().map(|&code| f64::from(code) / 255.0), colour)
    };
    Ok(Picture::whole(Film { width, height, rgb }, precision))
}

/// Bits per code in the file. A palette's colours have 8, at any size of its indices.
fn bits(info: &Info) -> u8 {
    match info.color_type {
        ColorType::Indexed => 8,
        _ => info.bit_depth as u8,
    }
}

/// Encoded values in [0, 1], one per sample of the colour type; the last sample of a pixel may be alpha.
fn film(encoded: impl Iterator<Item = f64>, colour: ColorType) -> Vec<[f32; 3]> {
    let linear: Vec<f32> = encoded.map(|e| srgb::linear(e) as f32).collect();
    let pixel = |samples: &[f32]| match *samples {
        [grey] | [grey, _] => [grey; 3],
        [r, g, b] | [r, g, b, _] => [r, g, b],
        // A pixel has 1 to 4 samples.
        _ => [f32::NAN; 3],
    };
    linear.chunks_exact(colour.samples()).map(pixel).collect()
}

/// Accepts a file without a statement about colours as sRGB, which is the convention, and one with gamma 1/2.2, by
/// which old writers mean sRGB (PNG 11.3.2.5). Any other statement about colours is refused, because comparisons need
/// radiance.
fn check_colours(info: &Info) -> Result<(), DecodeError> {
    let refuse = |what: &str| Err(DecodeError::Colours(what.to_owned()));
    if let Some(cicp) = info.coding_independent_code_points {
        // ITU-T H.273: primaries of BT.709, transfer of IEC 61966-2-1, RGB.
        let srgb = (cicp.color_primaries, cicp.transfer_function) == (1, 13);
        return match srgb && cicp.matrix_coefficients == 0 && cicp.is_video_full_range_image {
            true => Ok(()),
            false => refuse("its cICP chunk names other colours"),
        };
    }
    if info.srgb.is_some() {
        return Ok(());
    }
    if info.icc_profile.is_some() {
        return refuse("it has a colour profile (iCCP chunk)");
    }
    let gamma = info.gama_chunk.map(|g| f64::from(g.into_value()));
    if gamma.is_some_and(|gamma| (gamma - 0.45455).abs() > 5e-4) {
        return refuse("its gAMA chunk names another transfer function");
    }
    let primaries = info.chrm_chunk.map(|c| {
        [c.red, c.green, c.blue, c.white]
            .map(|(x, y)| [f64::from(x.into_value()), f64::from(y.into_value())])
    });
    match primaries {
        Some(primaries) if !primaries::are_srgb(primaries) => {
            refuse("its cHRM chunk names other primaries")
        }
        _ => Ok(()),
    }
}

impl From<DecodingError> for DecodeError {
    fn from(error: DecodingError) -> Self {
        match error {
            DecodingError::IoError(_) => Self::Broken("it is truncated".to_owned()),
            error => Self::Broken(error.to_string()),
        }
    }
}

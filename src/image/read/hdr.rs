//! Radiance HDR, by its reference (radsite.lbl.gov/radiance/refer/filefmts.pdf).

use std::io::Read;

use ::image::codecs::hdr::{HdrDecoder, HdrMetadata, SIGNATURE};
use ::image::{ImageDecoder, ImageError};

use super::{DecodeError, Picture, pixels};
use crate::film::Film;
use crate::image::{Precision, primaries};

pub fn decode(bytes: &[u8]) -> Result<Picture, DecodeError> {
    // The crate requires Radiance's own first line.
    let first_line = bytes.iter().take_while(|&&byte| byte != b'\n').count();
    let decoder = HdrDecoder::new(SIGNATURE.chain(&bytes[first_line..]))?;
    let header = decoder.metadata();
    check_colours(&header)?;
    let exposure = exposure(&header)?;

    let (width, height) = decoder.dimensions();
    let pixels = pixels(width.into(), height.into(), 4, bytes)?;
    let mut rgb = vec![[0.0f32; 3]; pixels];
    decoder.read_image(bytemuck::cast_slice_mut(&mut rgb))?;
    for value in rgb.as_flattened_mut() {
        *value /= exposure;
    }
    let film = Film { width, height, rgb };
    Ok(Picture::whole(film, Precision::Rgbe))
}

/// The factor that radiance was multiplied by before writing.
fn exposure(header: &HdrMetadata) -> Result<f32, DecodeError> {
    match header.exposure.unwrap_or(1.0) {
        exposure if exposure > 0.0 && exposure.is_finite() => Ok(exposure),
        exposure => Err(DecodeError::Broken(format!("an exposure of {exposure}"))),
    }
}

/// `PRIMARIES` are xy of red, green, blue and white; `COLORCORR` is a factor for each channel.
fn check_colours(header: &HdrMetadata) -> Result<(), DecodeError> {
    if header
        .color_correction
        .is_some_and(|c| c != (1.0, 1.0, 1.0))
    {
        return Err(DecodeError::Colours(
            "its COLORCORR changes them".to_owned(),
        ));
    }
    let given = header
        .custom_attributes
        .iter()
        .filter(|(k, _)| k == "PRIMARIES");
    for (_, value) in given {
        let numbers = value.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().unwrap_or_default();
        let [rx, ry, gx, gy, bx, by, wx, wy] = numbers[..] else {
            return Err(DecodeError::Broken(format!("primaries of {value}")));
        };
        if !primaries::are_srgb([[rx, ry], [gx, gy], [bx, by], [wx, wy]]) {
            return Err(DecodeError::Colours("its PRIMARIES differ".to_owned()));
        }
    }
    Ok(())
}

impl From<ImageError> for DecodeError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::Unsupported(what) => Self::Unsupported(what.to_string()),
            ImageError::IoError(_) => Self::Broken("it is truncated".to_owned()),
            error => Self::Broken(error.to_string()),
        }
    }
}

//! Two comparable pictures.

use super::MetricsError;
use crate::film::Film;

/// A test picture and its reference: of the same size, not empty, finite in every channel.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    test: &'a Film,
    reference: &'a Film,
}

impl<'a> Pair<'a> {
    pub fn new(test: &'a Film, reference: &'a Film) -> Result<Self, MetricsError> {
        check(test, "test picture")?;
        check(reference, "reference")?;
        same_size((test, "test picture"), (reference, "reference"))?;
        Ok(Self { test, reference })
    }

    pub fn test(&self) -> &'a Film {
        self.test
    }

    pub fn reference(&self) -> &'a Film {
        self.reference
    }

    /// `error(x, r)` of the test picture's x and the reference's r, mean over the channels of each pixel.
    pub fn per_pixel(&self, error: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let of_pixel = |(x, r): (&[f32; 3], &[f32; 3])| {
            let of_channel = |c: usize| error(f64::from(x[c]), f64::from(r[c]));
            (of_channel(0) + of_channel(1) + of_channel(2)) / 3.0
        };
        let pixels = self.test.rgb.iter().zip(&self.reference.rgb);
        pixels.map(of_pixel).collect()
    }
}

/// Checks that a film has pixels, as many as its size requires, and that all are finite.
pub(super) fn check(film: &Film, picture: &'static str) -> Result<(), MetricsError> {
    check_values(film, picture, f32::is_finite)
}

/// The same for standard errors, which must not be negative either.
pub(super) fn check_errors(film: &Film, picture: &'static str) -> Result<(), MetricsError> {
    check_values(film, picture, |v| v.is_finite() && v >= 0.0)
}

fn check_values(
    film: &Film,
    picture: &'static str,
    is_good: impl Fn(f32) -> bool,
) -> Result<(), MetricsError> {
    let &Film {
        width,
        height,
        ref rgb,
    } = film;
    if rgb.is_empty() {
        return Err(MetricsError::Empty { picture });
    }
    if u64::from(width) * u64::from(height) != rgb.len() as u64 {
        return Err(MetricsError::Film {
            picture,
            width,
            height,
            pixels: rgb.len(),
        });
    }
    let bad = rgb.iter().flatten().position(|&v| !is_good(v));
    let Some((pixel, channel)) = bad.map(|i| (i / 3, i % 3)) else {
        return Ok(());
    };
    Err(MetricsError::Value {
        picture,
        x: pixel % width as usize,
        y: pixel / width as usize,
        channel: ['R', 'G', 'B'][channel],
        value: rgb[pixel][channel],
    })
}

/// Checks that two films, given with their names, have the same size.
pub(super) fn same_size(
    (a, picture): (&Film, &'static str),
    (b, other): (&Film, &'static str),
) -> Result<(), MetricsError> {
    let (size, other_size) = ([a.width, a.height], [b.width, b.height]);
    if size == other_size {
        return Ok(());
    }
    Err(MetricsError::Sizes {
        picture,
        size,
        other,
        other_size,
    })
}

//! How wrong a denoised picture is, at most: by two noisy pictures that are independent of it and of each other.
//!
//! A denoised picture has an error that its own noise does not show. Let D be it, r what a renderer converges to, and b₁ and b₂
//! unbiased pictures by samples of their own:
//!
//! ```text
//! E (D − b₁)(D − b₂) = (D − r)²
//! ```
//!
//! so w (D − b₁)(D − b₂), w = 1/(D² + ε), is on average what a pixel adds to the relMSE of D, taken relative to D itself. It may be
//! negative, and is mostly noise: an upper end is all that it tells.

use statrs::distribution::{ContinuousCDF, StudentsT};

use super::MetricsError;
use super::pair::{check, same_size};
use super::rel_mse::relative;
use crate::film::Film;

/// What is known of the mean of (D − r)²/(D² + 0.01) over pixels and channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Unbiased; may be below 0.
    pub estimate: f64,
    /// Below this with a probability of 95 %, and never below 0.
    pub upper: f64,
}

/// Width and height of the blocks whose sums are taken for independent: light paths bring light to several pixels.
const BLOCK: usize = 8;
/// The least number of blocks that tells how far their sums spread.
const LEAST: usize = 12;
const LEVEL: f64 = 0.95;

/// The bound of `denoised`; `None` of a picture of less than 12 blocks of 8 × 8 pixels.
///
/// # Errors
/// If the films differ in size, have no pixels, or hold what is not finite.
pub fn bound(denoised: &Film, [a, b]: [&Film; 2]) -> Result<Option<Bound>, MetricsError> {
    for (film, name) in [(denoised, "denoised picture"), (a, "first"), (b, "second")] {
        check(film, name)?;
        same_size((denoised, "denoised picture"), (film, name))?;
    }
    let (width, height) = (denoised.width as usize, denoised.height as usize);
    let [columns, rows] = [width, height].map(|size| (size / BLOCK).max(1));
    let blocks = columns * rows;
    if blocks < LEAST {
        return Ok(None);
    }
    let mut sums = vec![(0.0, 0.0); blocks];
    for i in 0..width * height {
        // The last of a row or column takes the remainder.
        let column = (i % width / BLOCK).min(columns - 1);
        let row = (i / width / BLOCK).min(rows - 1);
        let (sum, pixels) = &mut sums[row * columns + column];
        *sum += term(denoised.rgb[i], a.rgb[i], b.rgb[i]);
        *pixels += 1.0;
    }
    let pixels = (width * height) as f64;
    let estimate = sums.iter().map(|(sum, _)| sum).sum::<f64>() / pixels;
    // Sums of n_b pixels: Var Σ = B/(B − 1) Σ (sum − n_b mean)². Part of that spread is that of the error itself: too much, if
    // anything.
    let squares = sums.iter().map(|(sum, n)| (sum - n * estimate).powi(2));
    let count = blocks as f64;
    let spread = (squares.sum::<f64>() * count / (count - 1.0)).sqrt() / pixels;
    let quantile =
        StudentsT::new(0.0, 1.0, count - 1.0).map_or(f64::INFINITY, |t| t.inverse_cdf(LEVEL));
    Ok(Some(Bound {
        estimate,
        upper: (estimate + quantile * spread).max(0.0),
    }))
}

/// What a pixel adds: the mean over its channels.
fn term(d: [f32; 3], a: [f32; 3], b: [f32; 3]) -> f64 {
    let channel = |c: usize| {
        let [d, a, b] = [d[c], a[c], b[c]].map(f64::from);
        relative((d - a) * (d - b), d)
    };
    [0, 1, 2].map(channel).iter().sum::<f64>() / 3.0
}

//! Errors of pictures: pure functions over films, every sum in f64.
//!
//! [`Pair`] checks two pictures once, so that no metric has to. [`Errors`] are single numbers; [`flip`], [`heatmap()`],
//! [`difference_map`] and [`worst_pixels`] show where they come from; [`blocks`] tests whether chance explains them;
//! [`convergence`] measures how fast they fall.

pub mod blocks;
pub mod convergence;
pub mod denoised;
mod difference;
mod error;
pub mod flip;
mod heatmap;
mod mse;
pub mod noise;
mod pair;
pub mod paired;
mod rel_mse;
mod smape;
mod standard_errors;
mod trimmed;
mod worst;

pub use difference::{
    DIFFERENCE_RANGE, difference_colour, difference_map, difference_scale, signed_difference,
};
pub use error::MetricsError;
pub use heatmap::{HEATMAP_RANGE, heatmap, heatmap_scale};
pub use pair::Pair;
pub use standard_errors::StandardErrors;
pub use trimmed::{Trimmed, trimmed};
pub use worst::{WorstPixel, worst_pixels};

use crate::film::Film;

/// The error of [`Pair`]'s test picture as single numbers: each metric is a mean over pixels and channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Mean of (x − r)², in the square of radiance.
    pub mse: Trimmed,
    /// √ of `mse`, in radiance; without the worst pixels, √ of the MSE without them.
    pub rmse: Trimmed,
    /// Mean of (x − r)²/(r² + 0.01).
    pub rel_mse: Trimmed,
    /// Mean of |x − r|/(|x| + |r| + 0.01), in [0, 1).
    pub smape: Trimmed,
    /// Mean RGB of the test picture.
    pub test_mean: [f64; 3],
    /// Mean RGB of the reference.
    pub reference_mean: [f64; 3],
}

impl Errors {
    pub fn of(pair: &Pair) -> Self {
        let mse = trimmed(&squared_errors(pair));
        Self {
            mse,
            rmse: mse.map(f64::sqrt),
            rel_mse: trimmed(&relative_squared_errors(pair)),
            smape: trimmed(&symmetric_errors(pair)),
            test_mean: mean(pair.test()),
            reference_mean: mean(pair.reference()),
        }
    }
}

/// Each pixel's (x − r)², mean over its channels.
pub fn squared_errors(pair: &Pair) -> Vec<f64> {
    pair.per_pixel(mse::squared_error)
}

/// Each pixel's (x − r)²/(r² + 0.01), mean over its channels.
pub fn relative_squared_errors(pair: &Pair) -> Vec<f64> {
    pair.per_pixel(rel_mse::relative_squared_error)
}

/// Each pixel's |x − r|/(|x| + |r| + 0.01), mean over its channels.
pub fn symmetric_errors(pair: &Pair) -> Vec<f64> {
    pair.per_pixel(smape::symmetric_error)
}

/// Mean RGB; NaN for a film without pixels.
pub fn mean(film: &Film) -> [f64; 3] {
    let n = film.rgb.len() as f64;
    [0, 1, 2].map(|c| {
        film.rgb
            .iter()
            .map(|pixel| f64::from(pixel[c]))
            .sum::<f64>()
            / n
    })
}

//! A picture, its standard errors and its rounding.

use crate::film::Film;
use crate::image::Precision;
use crate::metrics::pair::{check, check_errors, same_size};
use crate::metrics::{MetricsError, StandardErrors};

/// The relative difference between two renderers that round differently: a path takes some two hundred operations, each
/// off by half a unit in the last place of f32; they add up like a random walk: √256 · 2⁻²⁴.
const ARITHMETIC: f64 = 1.0 / (1 << 20) as f64;

/// A picture and its uncertainty.
#[derive(Clone, Copy, Debug)]
pub struct Estimate<'a> {
    pub mean: &'a Film,
    pub stderr: Stderr<'a>,
    /// The rounding of its file; `Single` for a film that comes from no file.
    pub precision: Precision,
}

/// The standard errors of a picture.
#[derive(Clone, Copy, Debug)]
pub enum Stderr<'a> {
    /// For each pixel and channel. Pixels are assumed to be independent, as they are under a filter of one pixel.
    PerPixel(StandardErrors<'a>),
    /// None: the picture is taken as exact. Any noise in it then counts as bias of the other.
    Exact,
}

impl Estimate<'_> {
    pub(super) fn check(
        &self,
        mean: &'static str,
        errors: &'static str,
    ) -> Result<(), MetricsError> {
        check(self.mean, mean)?;
        if let Stderr::PerPixel(StandardErrors { film, .. }) = self.stderr {
            check_errors(film, errors)?;
            same_size((self.mean, mean), (film, errors))?;
        }
        let bounded = self.precision != Precision::Lossy;
        bounded
            .then_some(())
            .ok_or(MetricsError::NoRounding { picture: mean })
    }

    /// Degrees of freedom of each standard error.
    pub(super) fn freedom(&self) -> f64 {
        match self.stderr {
            Stderr::PerPixel(errors) => errors.freedom,
            Stderr::Exact => f64::INFINITY,
        }
    }

    /// The `i`-th pixel's value, standard error and bound on the rounding error, for each channel.
    pub(super) fn pixel(&self, i: usize) -> ([f64; 3], [f64; 3], [f64; 3]) {
        let value = self.mean.rgb[i];
        let error = match self.stderr {
            Stderr::PerPixel(errors) => errors.film.rgb[i].map(f64::from),
            Stderr::Exact => [0.0; 3],
        };
        // `check` has refused formats without a bound.
        let stored = self.precision.rounding(value).unwrap_or_default();
        let value = value.map(f64::from);
        let rounding = [0, 1, 2].map(|c| stored[c] + ARITHMETIC * value[c].abs());
        (value, error, rounding)
    }
}

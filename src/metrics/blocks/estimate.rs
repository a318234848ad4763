//! A picture, its standard errors and its file's rounding.

use crate::film::Film;
use crate::metrics::MetricsError;
use crate::metrics::pair::{check, check_errors, same_size};

/// A picture and how well it is known.
#[derive(Clone, Copy, Debug)]
pub struct Estimate<'a> {
    pub mean: &'a Film,
    pub stderr: Stderr<'a>,
    pub rounding: Rounding,
}

/// The standard errors of a picture.
#[derive(Clone, Copy, Debug)]
pub enum Stderr<'a> {
    /// Of each pixel and channel, as the picture's unit. Pixels are taken for independent, which they are
    /// under a filter of one pixel.
    PerPixel(&'a Film),
    /// None: the picture is taken for the truth. Any noise in it is then taken for the other's bias.
    Exact,
}

/// What a file's format makes of a value: x stands for anything in x ± (`relative` · |x| + `absolute`).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rounding {
    pub relative: f64,
    pub absolute: f64,
}

impl Rounding {
    pub(super) fn of(&self, value: f64) -> f64 {
        self.relative * value.abs() + self.absolute
    }
}

impl Estimate<'_> {
    pub(super) fn check(
        &self,
        mean: &'static str,
        errors: &'static str,
    ) -> Result<(), MetricsError> {
        check(self.mean, mean)?;
        if let Stderr::PerPixel(film) = self.stderr {
            check_errors(film, errors)?;
            same_size((self.mean, mean), (film, errors))?;
        }
        Ok(())
    }
}

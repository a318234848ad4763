//! Data that a part keeps of each pixel in addition to its sums.

use rayon::prelude::*;

use crate::film::Keeps;
use crate::reference::film::{
    FilmMoments, FilmQuarters, film_join_moments, film_join_quarters, film_moments, film_quarters,
};
use crate::reference::math::{Real, Vec3};

/// One value per pixel, over consecutive samples.
#[derive(Clone, Debug, PartialEq)]
pub enum Beside<F> {
    Nothing,
    /// For standard errors.
    Moments(Vec<FilmMoments<F>>),
    /// For a denoised picture and its error estimate.
    Quarters(Vec<FilmQuarters<F>>),
}

/// A reference to one of those values, if any.
pub enum BesideMut<'a, F> {
    Nothing,
    Moments(&'a mut FilmMoments<F>),
    Quarters(&'a mut FilmQuarters<F>),
}

impl<F: Real> BesideMut<'_, F> {
    /// Adds sample number `n`, counted from 1.
    pub fn add(&mut self, radiance: Vec3<F>, n: u32) {
        match self {
            Self::Nothing => {}
            Self::Moments(moments) => film_moments(moments, radiance, n),
            Self::Quarters(quarters) => film_quarters(quarters, radiance, n),
        }
    }
}

impl<F: Real> Beside<F> {
    /// The values for no samples, with this many pixels.
    pub fn zero(keeps: Keeps, pixels: usize) -> Self {
        match keeps {
            Keeps::Nothing => Self::Nothing,
            Keeps::Moments => Self::Moments(vec![FilmMoments::default(); pixels]),
            Keeps::Quarters => Self::Quarters(vec![FilmQuarters::default(); pixels]),
        }
    }

    /// Resets all values.
    pub fn clear(&mut self) {
        match self {
            Self::Nothing => {}
            Self::Moments(moments) => moments.fill(FilmMoments::default()),
            Self::Quarters(quarters) => quarters.fill(FilmQuarters::default()),
        }
    }

    /// The value of pixel `i`.
    pub fn at(&mut self, i: usize) -> BesideMut<'_, F> {
        match self {
            Self::Nothing => BesideMut::Nothing,
            Self::Moments(moments) => BesideMut::Moments(&mut moments[i]),
            Self::Quarters(quarters) => BesideMut::Quarters(&mut quarters[i]),
        }
    }

    /// Adds sample number `n`, counted from 1, to every pixel.
    pub fn add(&mut self, values: &[Vec3<F>], n: u32) {
        match self {
            Self::Nothing => {}
            Self::Moments(moments) => {
                let pixels = moments.par_iter_mut().zip(values);
                pixels.for_each(|(moments, &x)| film_moments(moments, x, n));
            }
            Self::Quarters(quarters) => {
                let pixels = quarters.par_iter_mut().zip(values);
                pixels.for_each(|(quarters, &x)| film_quarters(quarters, x, n));
            }
        }
    }

    /// Combines the values of `m` ≥ 1 samples with those of `n` ≥ 1 `later` ones.
    pub fn join(&mut self, m: u32, later: &Self, n: u32) {
        match (self, later) {
            (Self::Moments(moments), Self::Moments(later)) => {
                let pixels = moments.par_iter_mut().zip(later);
                pixels.for_each(|(a, b)| *a = film_join_moments(a, m, b, n));
            }
            (Self::Quarters(quarters), Self::Quarters(later)) => {
                let pixels = quarters.par_iter_mut().zip(later);
                pixels.for_each(|(a, &b)| *a = film_join_quarters(*a, b, n));
            }
            _ => {}
        }
    }

    /// The values of some of the pixels.
    pub fn of(&self, places: impl Iterator<Item = std::ops::Range<usize>>) -> Self {
        match self {
            Self::Nothing => Self::Nothing,
            Self::Moments(moments) => {
                Self::Moments(places.flat_map(|place| &moments[place]).copied().collect())
            }
            Self::Quarters(quarters) => {
                Self::Quarters(places.flat_map(|place| &quarters[place]).copied().collect())
            }
        }
    }

    /// Copies the values of the pixels `from` of `other` to `to`.
    pub fn put(&mut self, to: std::ops::Range<usize>, other: &Self, from: std::ops::Range<usize>) {
        match (self, other) {
            (Self::Moments(all), Self::Moments(other)) => all[to].copy_from_slice(&other[from]),
            (Self::Quarters(all), Self::Quarters(other)) => all[to].copy_from_slice(&other[from]),
            _ => {}
        }
    }
}

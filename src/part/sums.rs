//! Sums over consecutive samples of every pixel.

use rayon::prelude::*;

use super::Beside;
use crate::film::Keeps;
use crate::reference::film::{FilmPixel, PixelSum, film_join, film_join_contrast, film_sample};
use crate::reference::math::{Real, Vec3};

/// The sums of a pixel's samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSums<F> {
    pub sum: PixelSum<F>,
    /// Σ ± sample ([`FilmPixel::contrast`]).
    pub contrast: Vec3<F>,
}

/// Sums over consecutive samples of every pixel, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Sums<F> {
    /// Samples of each pixel.
    pub samples: u32,
    pub pixels: Vec<PixelSums<F>>,
    pub beside: Beside<F>,
}

impl<F: Real> PixelSums<F> {
    /// The sums of no samples.
    pub fn zero() -> Self {
        Self {
            sum: PixelSum::zero(),
            contrast: Vec3::zero(),
        }
    }

    /// Joins both; `later` has `n` samples.
    fn join(self, later: Self, n: u32) -> Self {
        Self {
            sum: film_join(self.sum, later.sum),
            contrast: film_join_contrast(self.contrast, later.contrast, n),
        }
    }
}

/// The sums of a pixel of a film, without its counters.
impl<F: Real> From<&FilmPixel<F>> for PixelSums<F> {
    fn from(pixel: &FilmPixel<F>) -> Self {
        Self {
            sum: pixel.sum,
            contrast: pixel.contrast,
        }
    }
}

/// A pixel that continues from these sums, with zero counters.
impl<F: Real> From<&PixelSums<F>> for FilmPixel<F> {
    fn from(sums: &PixelSums<F>) -> Self {
        Self {
            sum: sums.sum,
            contrast: sums.contrast,
            ..Self::default()
        }
    }
}

impl<F: Real> Sums<F> {
    /// The sums of no samples for this many pixels.
    pub fn zero(pixels: usize, keeps: Keeps) -> Self {
        Self {
            samples: 0,
            pixels: vec![PixelSums::zero(); pixels],
            beside: Beside::zero(keeps, pixels),
        }
    }

    /// Adds one sample to every pixel as in the film ([`film_sample`]): `values` were samples before, so they are
    /// finite.
    pub fn add(&mut self, values: &[Vec3<F>]) {
        let n = self.samples + 1;
        let pixels = self.pixels.par_iter_mut().zip(values);
        pixels.for_each(|(sums, &x)| {
            let mut pixel = FilmPixel::from(&*sums);
            film_sample(&mut pixel, x);
            *sums = PixelSums::from(&pixel);
        });
        self.beside.add(values, n);
        self.samples = n;
    }

    /// Appends the samples that follow.
    pub fn join(&mut self, later: &Self) {
        let (m, n) = (self.samples, later.samples);
        if n == 0 {
            return;
        }
        if m == 0 {
            self.clone_from(later);
            return;
        }
        let pixels = self.pixels.par_iter_mut().zip(&later.pixels);
        pixels.for_each(|(a, &b)| *a = a.join(b, n));
        self.beside.join(m, &later.beside, n);
        self.samples = m + n;
    }
}

//! Computes pictures from sums.

use super::{Beside, Keeps, Part, Sums};
use crate::film::Film;
use crate::reference::film::{film_half_difference, film_mean, film_stderr};
use crate::reference::math::{Real, Vec3};
use crate::sample::GROUPS;

/// A picture and (a − b)/2 for the means a and b of its two groups of samples.
pub struct Halves {
    pub mean: Film,
    pub half_difference: Film,
}

impl<F: Real> Part<F> {
    /// The sums of all samples, in the fixed order.
    pub(super) fn total(&self) -> Sums<F> {
        let [width, height] = self.size;
        let mut total = Sums::zero((width * height) as usize, self.keeps);
        self.head.iter().for_each(|values| total.add(values));
        let later = self.nodes.iter().chain(&self.tail);
        later.for_each(|sums| total.join(sums));
        total
    }

    /// The mean of all samples, at least one.
    pub fn picture(&self) -> Film {
        self.mean(&self.total())
    }

    /// The mean, with half the difference of its two groups of samples, at least two samples.
    pub fn halves(&self) -> Halves {
        let total = self.total();
        Halves {
            mean: self.mean(&total),
            half_difference: self.half_difference(&total),
        }
    }

    /// The standard errors of the mean of at least two samples.
    ///
    /// The square of each estimates the variance of its pixel's mean in its channel. Moments are kept only for
    /// independent samples: then it comes from their spread ([`film_stderr`]). Otherwise it comes from the two groups,
    /// which are independent of each other, while the samples within a group may not be ([`film_half_difference`]). The
    /// estimate is unbiased, except for an odd number of dependent samples.
    pub fn standard_errors(&self) -> Film {
        let total = self.total();
        let n = total.samples;
        if let Beside::Moments(moments) = &total.beside {
            return self.film(moments.iter().map(|m| film_stderr(m, n)));
        }
        let mut half = self.half_difference(&total);
        for x in half.rgb.as_flattened_mut() {
            *x = x.abs();
        }
        half
    }

    /// Degrees of freedom of each standard error: n − 1 for the spread of n samples, 1 for the difference of two groups.
    pub fn freedom(&self) -> f64 {
        let n = match self.keeps {
            Keeps::Moments => self.samples(),
            Keeps::Nothing | Keeps::Quarters => GROUPS,
        };
        f64::from(n) - 1.0
    }

    fn mean(&self, total: &Sums<F>) -> Film {
        let n = total.samples;
        self.film(total.pixels.iter().map(|p| film_mean(p.sum, n)))
    }

    fn half_difference(&self, total: &Sums<F>) -> Film {
        let n = total.samples;
        let pixels = total.pixels.iter();
        self.film(pixels.map(|p| film_half_difference(p.sum, p.contrast, n)))
    }

    fn film(&self, values: impl Iterator<Item = Vec3<F>>) -> Film {
        let [width, height] = self.size;
        Film {
            width,
            height,
            rgb: values.map(|v| v.f64().as_vec3().to_array()).collect(),
        }
    }
}

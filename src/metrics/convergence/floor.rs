//! Tests whether pictures converge to the reference or to something else.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::interval::mean;
use super::reference::Reference;
use crate::film::Film;

/// Probability of reporting a floor for pictures that converge to the reference.
const ALPHA: f64 = 1e-3;

/// The relMSE that remains with any number of samples: the level at which the curve flattens.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Floor {
    pub rel_mse: f64,
    pub standard_error: f64,
    /// The probability of at least this value by chance, if pictures and reference have the same mean (and the
    /// reference has its stated error).
    pub p: f64,
}

impl Floor {
    /// Whether chance does not explain it.
    pub fn is_there(&self) -> bool {
        self.p < ALPHA
    }
}

/// The floor of replicates' `pictures`, all of the reference's size and with equal numbers of samples.
///
/// The error of one picture is noise and bias, E (x − r)² = σ²/n + b². The noise of two independent pictures does not
/// correlate: E (x − r)(y − r) = b², at any n. So the mean over all pairs is an unbiased estimate of b² that detects a
/// bias long before the curve shows it.
///
/// The pairs of a picture share its noise, and all pairs share the reference's. So the standard error is that of the
/// jackknife over pictures, plus the effect of the reference's noise on all of them; the test is a one-sided one by
/// Student's t with as many degrees of freedom as the jackknife has. It is conservative: without a bias the pairs
/// hardly correlate, and the jackknife is up to √2 too large.
///
/// The reference's own noise, as stated by it, is subtracted (except for halves, whose noise contributes nothing on
/// average). `None` with fewer than three pictures.
pub fn floor(pictures: &[Film], reference: &Reference) -> Option<Floor> {
    if pictures.len() < 3 {
        return None;
    }
    let pairs = Pairs::new(pictures, reference);
    let rel_mse = mean(&pairs.values);
    let standard_error = pairs.jackknife().hypot(reference.own_spread());
    Some(Floor {
        rel_mse,
        standard_error,
        p: p_of_no_bias(rel_mse, standard_error, pictures.len())?,
    })
}

/// The probability of at least this floor without bias.
fn p_of_no_bias(rel_mse: f64, standard_error: f64, pictures: usize) -> Option<f64> {
    let t = StudentsT::new(0.0, 1.0, pictures as f64 - 1.0).ok()?;
    Some(match standard_error {
        0.0 if rel_mse > 0.0 => 0.0,
        0.0 => 1.0,
        _ => t.sf(rel_mse / standard_error),
    })
}

/// (x − r)(y − r) for all pairs of pictures, without the reference's noise.
struct Pairs {
    values: Vec<f64>,
    /// For each picture, the sum over its pairs.
    sums: Vec<f64>,
}

impl Pairs {
    fn new(pictures: &[Film], reference: &Reference) -> Self {
        let noise = reference.noise();
        let (mut values, mut sums) = (Vec::new(), vec![0.0; pictures.len()]);
        for (i, x) in pictures.iter().enumerate() {
            for (j, y) in pictures[..i].iter().enumerate() {
                let value = reference.covariance(x, y) - noise;
                values.push(value);
                sums[i] += value;
                sums[j] += value;
            }
        }
        Self { values, sums }
    }

    /// The standard error of the pairs' mean, from the means without each picture in turn (Arvesen, Jackknifing
    /// U-Statistics, Ann. Math. Statist. 40, 1969): (k − 1)/k Σ (h̄₍ᵢ₎ − h̄₍·₎)². It is too large for a degenerate
    /// statistic.
    fn jackknife(&self) -> f64 {
        let k = self.sums.len() as f64;
        let all: f64 = self.values.iter().sum();
        let without = |sum: &f64| (all - sum) / (0.5 * (k - 1.0) * (k - 2.0));
        let without: Vec<f64> = self.sums.iter().map(without).collect();
        let centre = mean(&without);
        let squares: f64 = without.iter().map(|h| (h - centre) * (h - centre)).sum();
        ((k - 1.0) / k * squares).sqrt()
    }
}

impl Reference {
    /// The part of [`Reference::covariance`] that is the reference's own noise.
    fn noise(&self) -> f64 {
        match self.is_halves() {
            true => 0.0,
            false => self.own().rel_mse.unwrap_or(0.0),
        }
    }
}

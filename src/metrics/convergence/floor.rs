//! Whether pictures converge to the reference, or to something else.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::interval::mean;
use super::reference::Reference;
use crate::film::Film;

/// Probability of calling pictures off that converge to the reference.
const ALPHA: f64 = 1e-3;

/// The relMSE that stays however many samples are taken: what the curve flattens to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Floor {
    pub rel_mse: f64,
    pub standard_error: f64,
    /// How likely as much is by chance, where pictures and reference have one mean (and the reference the error that
    /// it says).
    pub p: f64,
}

impl Floor {
    /// Whether chance does not explain it.
    pub fn is_there(&self) -> bool {
        self.p < ALPHA
    }
}

/// The floor of replicates' `pictures`, all of the reference's size and with as many samples each.
///
/// The error of one picture is noise and bias, E (x − r)² = σ²/n + b². Of two independent pictures the noise does not
/// correlate: E (x − r)(y − r) = b², at any n. So the mean over all pairs is an unbiased estimate of b² that sees a
/// bias long before the curve shows it. Without a bias the M = k(k − 1)/2 pairs are uncorrelated (a degenerate
/// U-statistic: Hoeffding, A Class of Statistics with Asymptotically Normal Distribution, Ann. Math. Statist. 19,
/// 1948, section 5), and sums over thousands of pixels: a one-sided t-test with M − 1 degrees of freedom. With one, the
/// pairs of a picture share its noise, and the standard error is that of the jackknife over pictures.
///
/// What the reference says its own noise is (not of halves, whose noise has no part in it) is taken off.
/// `None` of fewer than three pictures.
pub fn floor(pictures: &[Film], reference: &Reference) -> Option<Floor> {
    if pictures.len() < 3 {
        return None;
    }
    let pairs = Pairs::new(pictures, reference);
    let rel_mse = mean(&pairs.values);
    Some(Floor {
        rel_mse,
        standard_error: pairs.jackknife(),
        p: p_of_no_bias(&pairs.values)?,
    })
}

/// How likely a mean as large as that of `pairs` is where they are uncorrelated and of mean 0.
fn p_of_no_bias(pairs: &[f64]) -> Option<f64> {
    let (n, mean) = (pairs.len() as f64, mean(pairs));
    let squares: f64 = pairs.iter().map(|h| (h - mean) * (h - mean)).sum();
    let error = (squares / (n - 1.0) / n).sqrt();
    let t = StudentsT::new(0.0, 1.0, n - 1.0).ok()?;
    Some(match error {
        0.0 if mean > 0.0 => 0.0,
        0.0 => 1.0,
        _ => t.sf(mean / error),
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
    /// U-Statistics, Ann. Math. Statist. 40, 1969): (k − 1)/k Σ (h̄₍ᵢ₎ − h̄₍·₎)². Of a degenerate one it is too large.
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

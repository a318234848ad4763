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
/// 1948, section 5), and sums over thousands of pixels: a one-sided t-test with M − 1 degrees of freedom.
///
/// What the reference says its own noise is (not of halves, whose noise has no part in it) is taken off.
/// `None` of fewer than three pictures.
pub fn floor(pictures: &[Film], reference: &Reference) -> Option<Floor> {
    let noise = reference.noise();
    let mut pairs = Vec::new();
    for (i, x) in pictures.iter().enumerate() {
        for y in &pictures[..i] {
            pairs.push(reference.covariance(x, y) - noise);
        }
    }
    let n = pairs.len() as f64;
    if n < 3.0 {
        return None;
    }
    let rel_mse = mean(&pairs);
    let squares: f64 = pairs.iter().map(|h| (h - rel_mse) * (h - rel_mse)).sum();
    let standard_error = (squares / (n - 1.0) / n).sqrt();
    let t = StudentsT::new(0.0, 1.0, n - 1.0).ok()?;
    let p = match standard_error {
        0.0 if rel_mse > 0.0 => 0.0,
        0.0 => 1.0,
        _ => t.sf(rel_mse / standard_error),
    };
    Some(Floor {
        rel_mse,
        standard_error,
        p,
    })
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

//! An estimate from few replicates, with a confidence interval.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// The probability that an interval contains the true value.
pub const LEVEL: f64 = 0.95;

/// An estimate with its interval of [`LEVEL`]; in the unit of the estimate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Interval {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

impl Interval {
    /// The mean of independent `values`, x̄ ± t·s/√n with Student's t of n − 1 degrees of freedom; `None` with fewer
    /// than two. Exact for normal values; too narrow where a few fireflies dominate the mean.
    pub fn of_mean(values: &[f64]) -> Option<Self> {
        let (mean, half) = mean_and_half_width(values)?;
        Some(Self {
            value: mean,
            low: mean - half,
            high: mean + half,
        })
    }

    pub fn contains(&self, x: f64) -> bool {
        (self.low..=self.high).contains(&x)
    }

    /// All three numbers mapped by the increasing function `f`.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self {
            value: f(self.value),
            low: f(self.low),
            high: f(self.high),
        }
    }
}

/// Mean of `values`, and half the width of its interval.
pub(super) fn mean_and_half_width(values: &[f64]) -> Option<(f64, f64)> {
    if values.len() < 2 {
        return None;
    }
    let n = values.len() as f64;
    let mean = mean(values);
    // s² = Σ(x − x̄)²/(n − 1)
    let variance = values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0);
    let t = StudentsT::new(0.0, 1.0, n - 1.0)
        .ok()?
        .inverse_cdf(0.5 + 0.5 * LEVEL);
    Some((mean, t * (variance / n).sqrt()))
}

/// NaN for none.
pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// t of 0.975 at 1, 3 and 7 degrees of freedom: 12.706, 3.182, 2.365 (NIST/SEMATECH e-Handbook of Statistical
    /// Methods, table 1.3.6.7.2).
    #[test]
    fn the_width_is_that_of_students_table() {
        for (values, t) in [
            (&[1.0, 3.0][..], 12.706),
            (&[1.0, 3.0, 1.0, 3.0], 3.182),
            (&[1.0, 3.0, 1.0, 3.0, 1.0, 3.0, 1.0, 3.0], 2.365),
        ] {
            let n = values.len() as f64;
            let interval = Interval::of_mean(values).expect("two values or more");
            assert_eq!(interval.value, 2.0);
            // s² = n/(n − 1)
            let half = t * (1.0 / (n - 1.0)).sqrt();
            assert!(((interval.high - 2.0) / half - 1.0).abs() < 5e-4);
            assert!(((2.0 - interval.low) / half - 1.0).abs() < 5e-4);
        }
        assert_eq!(Interval::of_mean(&[1.0]), None);
    }
}

//! Summarises the errors of all replicates at one step.

use serde::Serialize;

use super::interval::{Interval, mean};
use crate::metrics::Trimmed;

/// The plain mean, and statistics that do not depend on a few pixels or on one replicate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Over replicates, with its interval; unbiased, but sensitive to fireflies.
    pub mean: Interval,
    /// The mean over replicates without the worst 1 % of pixels of each ([`Trimmed`]); below the mean.
    pub trimmed: f64,
    /// The median of the replicates, each a mean over all pixels: the median of means (Lugosi and Mendelson, Mean
    /// Estimation and Regression under Heavy-Tailed Distributions, Found. Comput. Math. 19, 2019, section 2.1).
    pub median_of_means: f64,
}

impl Summary {
    /// One error per replicate; `None` with fewer than two.
    pub fn of(errors: &[Trimmed]) -> Option<Self> {
        let all: Vec<f64> = errors.iter().map(|e| e.all).collect();
        let without: Vec<f64> = errors.iter().map(|e| e.without_worst).collect();
        Some(Self {
            mean: Interval::of_mean(&all)?,
            trimmed: mean(&without),
            median_of_means: median(&all),
        })
    }
}

/// The middle value, or the mean of the two in the middle; NaN for none.
pub fn median(values: &[f64]) -> f64 {
    let mut ranked = values.to_vec();
    ranked.sort_unstable_by(f64::total_cmp);
    let n = ranked.len();
    match n {
        0 => f64::NAN,
        _ if n % 2 == 1 => ranked[n / 2],
        _ => 0.5 * (ranked[n / 2 - 1] + ranked[n / 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_firefly_moves_the_mean_alone() {
        let calm = Trimmed {
            all: 1.0,
            without_worst: 0.5,
        };
        let firefly = Trimmed { all: 81.0, ..calm };
        let summary = Summary::of(&[calm, calm, firefly, calm]).expect("four replicates");
        assert_eq!(summary.mean.value, 21.0);
        assert_eq!((summary.trimmed, summary.median_of_means), (0.5, 1.0));
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(&[]).is_nan());
    }
}

//! Tests whether diverged paths contribute, on average, the same light in both renderers.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability of reporting a bias for unbiased paths.
pub const ALPHA: f64 = 1e-3;

/// With fewer pairs of different radiance there is no verdict.
pub const ENOUGH: u64 = 30;

/// Mean and spread of the differences a − b, per channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Diverged {
    pub paths: u64,
    /// Pairs with different radiance: many end in the dark on both sides.
    pub different: u64,
    mean: [f64; 3],
    /// Σ(d − mean)²
    squares: [f64; 3],
}

/// The result of the test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Fewer than `ENOUGH` pairs differ.
    TooFew,
    /// No evidence of a bias; the probability of such means without bias.
    Unbiased(f64),
    Biased(f64),
}

impl Diverged {
    /// Adds a difference. Welford, Note on a Method for Calculating Corrected Sums of Squares and Products,
    /// Technometrics 4(3), 1962.
    pub fn add(&mut self, difference: [f64; 3]) {
        self.paths += 1;
        self.different += u64::from(difference != [0.0; 3]);
        for (c, d) in difference.into_iter().enumerate() {
            let before = d - self.mean[c];
            self.mean[c] += before / self.paths as f64;
            self.squares[c] += before * (d - self.mean[c]);
        }
    }

    /// The mean difference.
    pub fn mean(&self) -> [f64; 3] {
        self.mean
    }

    /// √(s²/n), s² = Σ(d − mean)²/(n − 1); infinite with fewer than two paths.
    pub fn standard_error(&self) -> [f64; 3] {
        let n = self.paths as f64;
        self.squares.map(|squares| match self.paths {
            0 | 1 => f64::INFINITY,
            _ => (squares / (n - 1.0) / n).sqrt(),
        })
    }

    /// Student's t-test of each channel's mean against 0, two-sided, over three channels by Šidák: p = 1 − (1 − min
    /// p_c)³ against `ALPHA`.
    ///
    /// Which of two renderers is pushed over an edge is a matter of rounding: the differences are nearly symmetric, and
    /// for long symmetric tails the test is conservative.
    pub fn verdict(&self) -> Verdict {
        if self.different < ENOUGH {
            return Verdict::TooFew;
        }
        let errors = self.standard_error();
        let least = [0, 1, 2]
            .map(|c| two_sided(self.mean[c], errors[c], self.paths))
            .into_iter()
            .fold(1.0, f64::min);
        let p = 1.0 - (1.0 - least).powi(3);
        if p < ALPHA {
            Verdict::Biased(p)
        } else {
            Verdict::Unbiased(p)
        }
    }
}

/// Probability of |t| ≥ |mean|/error with n − 1 degrees of freedom.
fn two_sided(mean: f64, error: f64, n: u64) -> f64 {
    if mean == 0.0 {
        return 1.0;
    }
    // A spread of 0 around a non-zero mean: t is infinite.
    StudentsT::new(0.0, 1.0, n as f64 - 1.0).map_or(1.0, |t| 2.0 * t.sf((mean / error).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Critical values of Student's t, two-sided: 5 % and 0.1 % at 30 and at 120 degrees of freedom
    /// (NIST/SEMATECH e-Handbook of Statistical Methods, table 1.3.6.7.2: 0.975, 0.999 and 0.9995).
    #[test]
    fn the_table_of_students_t() {
        for (t, n, p) in [(2.042, 31, 0.05), (3.385, 31, 0.002), (1.980, 121, 0.05)] {
            let ours = two_sided(-t, 1.0, n);
            assert!((ours / p - 1.0).abs() < 2e-3, "{t}, {n}: {ours}");
        }
        assert_eq!(two_sided(0.0, 0.0, 40), 1.0);
        assert_eq!(two_sided(1e-9, 0.0, 40), 0.0);
    }

    #[test]
    fn mean_and_standard_error() {
        let mut diverged = Diverged::default();
        for d in [1.0, 2.0, 4.0, 5.0] {
            diverged.add([d, -d, 0.0]);
        }
        // s² = (4 + 1 + 1 + 4)/3
        let error = (10.0f64 / 3.0 / 4.0).sqrt();
        let close = |a: [f64; 3], b: [f64; 3]| (0..3).all(|c| (a[c] - b[c]).abs() < 1e-15);
        assert!(close(diverged.mean(), [3.0, -3.0, 0.0]));
        assert!(close(diverged.standard_error(), [error, error, 0.0]));
        assert_eq!(Diverged::default().standard_error(), [f64::INFINITY; 3]);
    }
}

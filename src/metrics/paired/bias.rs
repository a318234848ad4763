//! Whether the paths that parted bring, on the mean, the same light to both renderers.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability of calling unbiased paths biased.
pub const ALPHA: f64 = 1e-3;

/// Fewer pairs of different radiance say nothing.
pub const ENOUGH: u64 = 30;

/// Mean and spread of the differences a − b, per channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parted {
    pub paths: u64,
    /// Those whose radiance differs: many end in the dark on both sides.
    pub different: u64,
    mean: [f64; 3],
    /// Σ(d − mean)²
    squares: [f64; 3],
}

/// What the test says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Less than [`ENOUGH`] pairs differ.
    TooFew,
    /// Nothing speaks against it; the probability of such means if there is no bias.
    Unbiased(f64),
    Biased(f64),
}

impl Parted {
    /// Takes in a difference. Welford, Note on a Method for Calculating Corrected Sums of Squares and Products,
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

    /// √(s²/n), s² = Σ(d − mean)²/(n − 1); infinite below two paths.
    pub fn standard_error(&self) -> [f64; 3] {
        let n = self.paths as f64;
        self.squares.map(|squares| match self.paths {
            0 | 1 => f64::INFINITY,
            _ => (squares / (n - 1.0) / n).sqrt(),
        })
    }

    /// Student's t-test of each channel's mean against 0, two-sided, over three channels by Šidák:
    /// p = 1 − (1 − min p_c)³ against [`ALPHA`].
    ///
    /// Which of two renderers is pushed over an edge is a matter of rounding: the differences are nearly symmetric,
    /// and for long symmetric tails the test errs on the quiet side.
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
    // A spread of 0 about a mean that is not 0: t is infinite.
    StudentsT::new(0.0, 1.0, n as f64 - 1.0).map_or(1.0, |t| 2.0 * t.sf((mean / error).abs()))
}

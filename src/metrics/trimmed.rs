//! A mean, and the same without the worst pixels.

/// A mean over pixels, and the mean without the worst 1 % of them: a caustic's fireflies dominate the first and are
/// absent from the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trimmed {
    pub all: f64,
    /// Without the ⌊n/100⌋ worst of n pixels: never more than 1 %, none of fewer than a hundred (the rounding of
    /// `scipy.stats.trim_mean`). A biased estimator of the mean, always below it.
    pub without_worst: f64,
}

impl Trimmed {
    /// Both numbers mapped by `f`.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self {
            all: f(self.all),
            without_worst: f(self.without_worst),
        }
    }
}

/// The means of per-pixel errors, trimmed by their own order; NaN for none.
pub fn trimmed(errors: &[f64]) -> Trimmed {
    let kept = errors.len() - errors.len() / 100;
    let mut ranked = errors.to_vec();
    ranked.sort_unstable_by(f64::total_cmp);
    Trimmed {
        all: mean(errors),
        without_worst: mean(&ranked[..kept]),
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

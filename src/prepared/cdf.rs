//! Discrete choices with probabilities that are exact in f32: cumulative counts out of 2²⁴.

use thiserror::Error;

/// All counts of a CDF together.
pub const CDF_TOTAL: u32 = 1 << 24;

/// Weights without a CDF.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum CdfError {
    #[error("no weight is positive: there is nothing to choose")]
    Empty,
    #[error("weight {0} is negative or not finite, or makes the sum overflow")]
    Invalid(usize),
    #[error("{0} positive weights, more than the limit of 2^24")]
    TooMany(usize),
}

/// The n + 1 cumulative counts of a choice among n weights, from 0 to 2²⁴.
///
/// Entry i is chosen where `cdf[i]` ≤ u24 < `cdf[i + 1]`, u24 a uniform integer below 2²⁴, so its probability is exactly
/// (`cdf[i + 1]` − `cdf[i]`)·2⁻²⁴. Every positive weight gets one count, so that every emitter can be chosen; the other
/// counts are shared in proportion, each within one count. A weight of 0 gets none and is never chosen.
pub fn quantised_cdf(weights: &[f64]) -> Result<Vec<u32>, CdfError> {
    let mut total = 0.0;
    for (i, &w) in weights.iter().enumerate() {
        total += w;
        if !(w >= 0.0 && total.is_finite()) {
            return Err(CdfError::Invalid(i));
        }
    }
    let positive = weights.iter().filter(|&&w| w > 0.0).count();
    if positive == 0 {
        return Err(CdfError::Empty);
    }
    if positive > CDF_TOTAL as usize {
        return Err(CdfError::TooMany(positive));
    }
    let shared = f64::from(CDF_TOTAL - positive as u32);
    let mut cdf = Vec::with_capacity(weights.len() + 1);
    cdf.push(0);
    let (mut own, mut sum) = (0, 0.0);
    for &w in weights {
        own += u32::from(w > 0.0);
        sum += w;
        // `total` comes from the same additions, so the last quotient is exactly 1.
        cdf.push(own + (shared * (sum / total)).round() as u32);
    }
    Ok(cdf)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(weights: &[f64]) -> Vec<u32> {
        let cdf = quantised_cdf(weights).expect("valid weights");
        assert_eq!(cdf.len(), weights.len() + 1);
        assert_eq!((cdf[0], cdf[weights.len()]), (0, CDF_TOTAL));
        cdf.windows(2).map(|c| c[1] - c[0]).collect()
    }

    #[test]
    fn equal_weights_share_equally() {
        assert_eq!(counts(&[3.0]), [1 << 24]);
        assert_eq!(counts(&[0.1, 0.1]), [1 << 23, 1 << 23]);
    }

    #[test]
    fn counts_follow_the_weights_within_one_count() {
        let weights: Vec<f64> = (0..1000).map(|i| f64::from(i * 37 % 101)).collect();
        let total: f64 = weights.iter().sum();
        let n = weights.iter().filter(|&&w| w > 0.0).count() as f64;
        for (&w, k) in weights.iter().zip(counts(&weights)) {
            let share = w / total * (f64::from(CDF_TOTAL) - n);
            let own = if w > 0.0 { 1.0 } else { 0.0 };
            assert!((f64::from(k) - own - share).abs() <= 1.0, "{w}: {k}");
        }
    }

    #[test]
    fn every_positive_weight_can_be_chosen_and_no_other() {
        let weights = [0.0, 1e-300, 1e9, 0.0, f64::MIN_POSITIVE, 0.0];
        let k = counts(&weights);
        for (w, k) in weights.iter().zip(k) {
            assert_eq!(*w > 0.0, k > 0, "{w}: {k}");
        }
    }

    #[test]
    fn a_weight_for_each_count_is_the_limit() {
        let mut weights = vec![1.0; CDF_TOTAL as usize];
        assert!(counts(&weights).iter().all(|&k| k == 1));
        weights.push(1.0);
        let n = weights.len();
        assert_eq!(quantised_cdf(&weights), Err(CdfError::TooMany(n)));
    }

    #[test]
    fn impossible_weights_are_refused() {
        assert_eq!(quantised_cdf(&[]), Err(CdfError::Empty));
        assert_eq!(quantised_cdf(&[0.0, 0.0]), Err(CdfError::Empty));
        assert_eq!(quantised_cdf(&[1.0, -1.0]), Err(CdfError::Invalid(1)));
        assert_eq!(quantised_cdf(&[f64::NAN]), Err(CdfError::Invalid(0)));
        assert_eq!(
            quantised_cdf(&[1.0, f64::INFINITY]),
            Err(CdfError::Invalid(1))
        );
        assert_eq!(
            quantised_cdf(&[f64::MAX, f64::MAX]),
            Err(CdfError::Invalid(1))
        );
    }
}

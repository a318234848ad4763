//! Significance.

use statrs::distribution::{Binomial, ChiSquared, ContinuousCDF, DiscreteCDF, StudentsT};

/// Significance of each of `tests` independent tests such that all of them together reject a truth with
/// probability `level`: 1 − (1 − level)^(1/tests) (Šidák 1967).
pub fn sidak(level: f64, tests: usize) -> f64 {
    -f64::exp_m1(f64::ln_1p(-level) / tests as f64)
}

/// P(χ² ≥ `statistic`); 1 without freedom, where one cell contains everything and its count says nothing.
pub fn chi_square_p(statistic: f64, freedom: usize) -> f64 {
    if freedom == 0 {
        return 1.0;
    }
    ChiSquared::new(freedom as f64).map_or(0.0, |d| d.sf(statistic))
}

/// P(|t| ≥ |`statistic`|).
pub fn student_p(statistic: f64, freedom: usize) -> f64 {
    StudentsT::new(0.0, 1.0, freedom as f64).map_or(0.0, |d| 2.0 * d.sf(statistic.abs()))
}

/// Two-sided probability of `hits` of `trials`, where one hit has a probability known to ± `uncertainty`.
pub fn binomial_p(hits: u64, trials: u64, probability: f64, uncertainty: f64) -> f64 {
    if probability < -uncertainty || probability > 1.0 + uncertainty {
        return 0.0;
    }
    let low = (probability - uncertainty).clamp(0.0, 1.0);
    let high = (probability + uncertainty).clamp(0.0, 1.0);
    let mean = hits as f64 / trials as f64;
    let p = mean.clamp(low, high);
    if p == mean {
        return 1.0;
    }
    let Ok(d) = Binomial::new(p, trials) else {
        return 0.0;
    };
    let tail = if mean < p {
        d.cdf(hits)
    } else {
        d.sf(hits.saturating_sub(1))
    };
    (2.0 * tail).min(1.0)
}

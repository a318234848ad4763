//! Statistics that several tests share.

use statrs::distribution::{ChiSquared, ContinuousCDF, StudentsT};

/// The level of each of `n` tests that makes a family's level `alpha`: 1 − (1 − α)^(1/n) (Šidák 1967).
pub fn sidak(alpha: f64, n: usize) -> f64 {
    1.0 - (1.0 - alpha).powf(1.0 / n as f64)
}

/// Mean and standard error of the mean.
pub fn mean_and_error(samples: &[f64]) -> (f64, f64) {
    let n = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / n;
    let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    (mean, (variance / n).sqrt())
}

/// Two-sided p-value of `samples` having the mean `expected` (Student's t).
///
/// Samples that are all equal have no error: they must equal the expectation within `rounding`.
pub fn p_of_mean(samples: &[f64], expected: f64, rounding: f64) -> f64 {
    let (mean, error) = mean_and_error(samples);
    let off = (mean - expected).abs();
    if off <= rounding {
        return 1.0;
    }
    if error == 0.0 {
        return 0.0;
    }
    let t = StudentsT::new(0.0, 1.0, samples.len() as f64 - 1.0).expect("two samples or more");
    2.0 * t.sf(off / error)
}

/// The shift of a mean that [`p_of_mean`] finds at `level`, but for once in 3.5 million (5 standard errors).
///
/// The mean of `groups` groups is that of `count` numbers in [0, `most`], whose variance is at most mean·(most − mean)
/// (Bhatia & Davis, A Better Bound on the Variance, American Mathematical Monthly 107, 2000). So it is known before any
/// number is drawn.
pub fn noticeable(level: f64, mean: f64, most: f64, count: f64, groups: usize) -> f64 {
    let error = (mean * (most - mean).max(0.0) / count).sqrt();
    let t = StudentsT::new(0.0, 1.0, groups as f64 - 1.0).expect("two groups or more");
    (t.inverse_cdf(1.0 - level / 2.0) + 5.0) * error
}

/// Two-sided p-value of two independent sets of samples having the same mean (Welch's t-test with the degrees of
/// freedom of Satterthwaite 1946).
pub fn p_of_difference(a: &[f64], b: &[f64]) -> f64 {
    let ((mean_a, error_a), (mean_b, error_b)) = (mean_and_error(a), mean_and_error(b));
    let error = error_a.hypot(error_b);
    if error == 0.0 {
        return if mean_a == mean_b { 1.0 } else { 0.0 };
    }
    let share = |error: f64, n: usize| error.powi(4) / (n as f64 - 1.0);
    let freedom = error.powi(4) / (share(error_a, a.len()) + share(error_b, b.len()));
    let t = StudentsT::new(0.0, 1.0, freedom).expect("two samples or more in each set");
    2.0 * t.sf((mean_a - mean_b).abs() / error)
}

/// p-value of a chi-square test of `counts` against `expected`; bins that expect less than 5 are pooled.
pub fn chi_square(counts: &[usize], expected: &[f64]) -> f64 {
    let mut pooled = (0.0, 0.0);
    let (mut sum, mut bins) = (0.0, 0);
    let term = |count: f64, expected: f64| (count - expected).powi(2) / expected;
    for (&count, &expected) in counts.iter().zip(expected) {
        if expected < 5.0 {
            pooled = (pooled.0 + count as f64, pooled.1 + expected);
        } else {
            sum += term(count as f64, expected);
            bins += 1;
        }
    }
    if pooled.1 >= 5.0 {
        sum += term(pooled.0, pooled.1);
        bins += 1;
    } else if pooled.0 > pooled.1 + 30.0 {
        // Hits where none are due, too few expected for a separate test.
        return 0.0;
    }
    let degrees = (bins - 1).max(1) as f64;
    1.0 - ChiSquared::new(degrees)
        .expect("degrees of freedom")
        .cdf(sum)
}

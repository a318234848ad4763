//! Ratios of means over replicates: slopes, efficiencies, and factors between estimators.

use super::interval::{Interval, mean, mean_and_half_width};

/// ln of the ratio of two products, the means of `over` and the means of `under`, and half the width of its interval.
/// All have one value per replicate and are paired by it, so that variation common to both sides cancels.
///
/// The delta method (Casella and Berger, Statistical Inference, 2nd ed., section 5.5.4): with means ā_i and b̄_j, L = Σ
/// ln ā_i − Σ ln b̄_j is to first order a mean over replicates of z_r = Σ a_ir/ā_i − Σ b_jr/b̄_j.
///
/// `None` with fewer than two replicates, or if a mean is not above 0.
fn log_ratio(over: &[&[f64]], under: &[&[f64]]) -> Option<(f64, f64)> {
    let all = || over.iter().chain(under);
    let replicates = all().map(|values| values.len()).min()?;
    if all().any(|values| mean(values) <= 0.0 || !mean(values).is_finite()) {
        return None;
    }
    let log = |sides: &[&[f64]]| sides.iter().map(|v| mean(v).ln()).sum::<f64>();
    let relative = |sides: &[&[f64]], r: usize| sides.iter().map(|v| v[r] / mean(v)).sum::<f64>();
    let z: Vec<f64> = (0..replicates)
        .map(|r| relative(over, r) - relative(under, r))
        .collect();
    let (_, half) = mean_and_half_width(&z)?;
    Some((log(over) - log(under), half))
}

fn ratio(over: &[&[f64]], under: &[&[f64]]) -> Option<Interval> {
    let (log, half) = log_ratio(over, under)?;
    let interval = Interval {
        value: log,
        low: log - half,
        high: log + half,
    };
    Some(interval.map(f64::exp))
}

/// The local slope between two steps of the same replicates on log–log axes, ln(ē_b/ē_a)/ln(n_b/n_a): −1 for the
/// (relative) MSE of independent samples, −½ for its root. `a` and `b`: samples per pixel, and one error per replicate.
///
/// It is taken over samples rather than seconds, because these are known without noise.
pub fn slope(a: (u32, &[f64]), b: (u32, &[f64])) -> Option<Interval> {
    let (log, half) = log_ratio(&[b.1], &[a.1])?;
    let step = (f64::from(b.0) / f64::from(a.0)).ln();
    (step > 0.0).then(|| Interval {
        value: log / step,
        low: (log - half) / step,
        high: (log + half) / step,
    })
}

/// 1/(error · seconds), which for independent samples does not depend on their number (Pharr, Jakob and Humphreys,
/// Physically Based Rendering, 4th ed., section 2.2: ε = 1/(V·T)). Both have one value per replicate.
pub fn efficiency(errors: &[f64], seconds: &[f64]) -> Option<Interval> {
    ratio(&[], &[errors, seconds])
}

/// The efficiency of `b` divided by that of `a`, paired by replicate; each is errors and seconds.
pub fn ratio_of_efficiencies(a: [&[f64]; 2], b: [&[f64]; 2]) -> Option<Interval> {
    ratio(&a, &b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_common_to_both_sides_cancel() {
        // b is always a third of a, at any spread of the replicates.
        let a = [3.0, 30.0, 6.0, 9.0];
        let b = a.map(|e| e / 3.0);
        let seconds = [1.0, 1.5, 2.0, 2.5];
        let better = ratio_of_efficiencies([&a, &seconds], [&b, &seconds]).expect("a ratio");
        for x in [better.value, better.low, better.high] {
            assert!((x - 3.0).abs() < 1e-12, "{better:?}");
        }
        let slope = slope((4, &a), (12, &b)).expect("a slope");
        assert!((slope.value + 1.0).abs() < 1e-12 && slope.high - slope.low < 1e-12);
    }

    #[test]
    fn values_without_a_logarithm_have_no_ratio() {
        let good = [1.0, 2.0];
        assert!(efficiency(&good, &good).is_some());
        for bad in [&[1.0, -1.0][..], &[0.0, 0.0], &[f64::NAN, 1.0], &[1.0]] {
            assert_eq!(efficiency(bad, &good[..bad.len()]), None, "{bad:?}");
            assert_eq!(slope((1, &good[..bad.len()]), (2, bad)), None, "{bad:?}");
        }
        assert_eq!(slope((2, &good), (2, &good)), None);
    }
}

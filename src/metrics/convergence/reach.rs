//! The time at which a curve of errors reaches a target.

use serde::Serialize;

/// Seconds until the error falls to a target.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "how", content = "seconds", rename_all = "snake_case")]
pub enum Reach {
    /// At the first step already: no more than its seconds.
    Before(f64),
    /// Between two steps.
    At(f64),
    /// Beyond the last step, on the line through the last two.
    Extrapolated(f64),
    /// Out of reach of the measurements.
    Never,
}

/// Limit of the extrapolation, as a multiple of the last step's seconds.
const FAR: f64 = 16.0;

/// A flatter curve is not extrapolated; independent samples have slope −1.
const FLAT: f64 = -0.25;

/// The first time at which the mean error of a curve of (seconds, error), seconds rising, falls to `target`:
/// interpolated on straight lines between steps on log–log axes. Beyond the last step, the line through the last two is
/// continued with a slope no steeper than −1: by chance it often is steeper, which would be too optimistic.
pub fn reach(curve: &[(f64, f64)], target: f64) -> Reach {
    let Some(first) = curve.iter().position(|&(_, error)| error <= target) else {
        return beyond(curve, target);
    };
    if first == 0 {
        return Reach::Before(curve[0].0);
    }
    let (a, b) = (curve[first - 1], curve[first]);
    // An error ≤ 0, by chance, has no logarithm: its step is the earliest known time.
    match log_slope(a, b) {
        Some(slope) => Reach::At(along(a, slope, target)),
        None => Reach::At(b.0),
    }
}

fn beyond(curve: &[(f64, f64)], target: f64) -> Reach {
    let [.., a, b] = *curve else {
        return Reach::Never;
    };
    let seconds = log_slope(a, b)
        .filter(|&slope| slope < FLAT)
        .map(|slope| along(b, slope.max(-1.0), target));
    match seconds {
        Some(seconds) if seconds <= FAR * b.0 => Reach::Extrapolated(seconds),
        _ => Reach::Never,
    }
}

/// Δ ln error / Δ ln seconds.
fn log_slope(a: (f64, f64), b: (f64, f64)) -> Option<f64> {
    let slope = (b.1 / a.1).ln() / (b.0 / a.0).ln();
    slope.is_finite().then_some(slope)
}

/// The seconds at which the line through `from` has the error `target`.
fn along(from: (f64, f64), slope: f64, target: f64) -> f64 {
    from.0 * (target / from.1).powf(1.0 / slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: Reach, expected: Reach) {
        let same = match (found, expected) {
            (Reach::Before(a), Reach::Before(b))
            | (Reach::At(a), Reach::At(b))
            | (Reach::Extrapolated(a), Reach::Extrapolated(b)) => (a / b - 1.0).abs() < 1e-12,
            (a, b) => a == b,
        };
        assert!(same, "{found:?}, not {expected:?}");
    }

    /// error = 0.3/seconds, at 1, 2, 4 … 32 seconds.
    #[test]
    fn on_a_line_it_is_where_the_line_is() {
        let curve: Vec<_> = (0..6).map(|i| 2f64.powi(i)).map(|s| (s, 0.3 / s)).collect();
        close(reach(&curve, 0.5), Reach::Before(1.0));
        close(reach(&curve, 0.1), Reach::At(3.0));
        close(reach(&curve, 0.3 / 32.0), Reach::At(32.0));
        close(reach(&curve, 0.003), Reach::Extrapolated(100.0));
        close(reach(&curve, 0.3 / 513.0), Reach::Never);
        // The first crossing counts, although the curve rises again.
        close(
            reach(&[(1.0, 4.0), (2.0, 1.0), (4.0, 2.0)], 2.0),
            Reach::At(2f64.sqrt()),
        );
    }

    #[test]
    fn a_flat_or_empty_curve_reaches_nothing() {
        let flat: Vec<_> = (0..6)
            .map(|i| 2f64.powi(i))
            .map(|s| (s, 0.1 + 0.3 / s))
            .collect();
        close(reach(&flat, 0.1), Reach::Never);
        close(reach(&[], 0.1), Reach::Never);
        close(reach(&[(1.0, 1.0)], 0.1), Reach::Never);
        // Below 0 by chance, where errors are products of two halves.
        close(reach(&[(1.0, 1.0), (2.0, -0.1)], 0.1), Reach::At(2.0));
    }

    #[test]
    fn a_lucky_last_step_promises_no_more_than_independent_samples_keep() {
        close(
            reach(&[(1.0, 1.0), (2.0, 0.25)], 0.125),
            Reach::Extrapolated(4.0),
        );
    }
}

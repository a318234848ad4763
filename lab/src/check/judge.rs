//! Compares measurements with the case's bounds.

use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, Normal};

use super::bound;
use super::case::{Case, Expectation};
use super::measure::Measured;
use crate::check::report::Held;
use vkpt::metrics::paired::{DARK, Verdict};
use vkpt::report::human::p_value;

/// Probability that a correct renderer fails a battery.
pub const ALPHA: f64 = 1e-3;

/// The rules by which cases are judged.
#[derive(Clone, Copy, Debug)]
pub struct Judge {
    /// The device rounds as the reference does, as CPU drivers do.
    pub correctly_rounded: bool,
    /// Level of each statistical statement.
    pub level: f64,
}

impl Judge {
    /// For a battery of `cases`: 1 − (1 − α)^(1/n) for n statements (Šidák 1967): for each case, the number of diverged paths,
    /// their bias, and the case's expectations.
    pub fn new<'a>(cases: impl Iterator<Item = &'a Case>, correctly_rounded: bool) -> Self {
        let statements: usize = cases.map(|case| 2 + case.expectations.len()).sum();
        let level = 1.0 - (1.0 - ALPHA).powf(1.0 / statements.max(1) as f64);
        Self {
            correctly_rounded,
            level,
        }
    }

    /// The case's measurements and bounds; `of` has the measurements of other cases.
    pub fn held<'m>(
        &self,
        case: &Case,
        m: &'m Measured,
        of: &dyn Fn(&str) -> Option<&'m Measured>,
    ) -> Vec<Held> {
        let mut held = self.bits(m).into_iter().collect::<Vec<_>>();
        held.extend([
            sound("NaN", m.nan),
            sound("infinities", m.infinite),
            sound("negative", m.negative),
        ]);
        held.extend(
            [self.diverged(case, m), self.close(case, m), self.bias(m)]
                .into_iter()
                .flatten(),
        );
        if let Some((most, why)) = &case.weight {
            let limit = most * (1.0 + case.stiffness.close());
            held.push(Held::new(
                "weight",
                m.largest,
                limit,
                format!("no path may contribute more than {most}: {why}"),
            ));
        }
        held.extend(
            case.expectations
                .iter()
                .map(|e| self.expected(e, case, m, of)),
        );
        held
    }

    /// Where the device rounds as the reference does, it equals cpu-f32.
    fn bits(&self, m: &Measured) -> Option<Held> {
        let unequal = (m.f32.paths - m.f32.equal) as f64;
        let why = "paths that differ from cpu-f32 in a bit, on a device that rounds like cpu-f32";
        self.correctly_rounded
            .then(|| Held::new("bits", unequal, 0.0, why))
    }

    /// No more paths diverge than a binomial distribution with the bound allows.
    fn diverged(&self, case: &Case, m: &Measured) -> Option<Held> {
        let share = case.stiffness.diverged();
        let limit = most_of(m.f64.paths, share, self.level)?;
        let s = &case.stiffness;
        let why = format!(
            "paths that diverge from cpu-f64: allowed is a fraction of {} vertices × 4 decisions × 128 roundings × condition {} × 2⁻²⁴ \
             = {share:.1e}, by chance {limit}; {}",
            s.vertices, s.decisions, s.why
        );
        Some(Held::new(
            "diverged",
            (m.f64.paths - m.f64.together) as f64,
            limit as f64,
            why,
        ))
    }

    fn close(&self, case: &Case, m: &Measured) -> Option<Held> {
        let s = &case.stiffness;
        let why = format!(
            "relative difference to cpu-f64, 99th percentile of the paths: {} vertices × 128 roundings × condition {} \
             × 2⁻²⁴; {}",
            s.vertices, s.light, s.why
        );
        let p99 = m.f64.closeness.quantile(0.99)?;
        Some(Held::new("99 %", p99, s.close(), why))
    }

    /// The mean contribution of diverged paths is the same on both sides.
    fn bias(&self, m: &Measured) -> Option<Held> {
        let p = match m.f64.diverged.verdict() {
            Verdict::TooFew => return None,
            Verdict::Unbiased(p) | Verdict::Biased(p) => p,
        };
        let why = format!(
            "mean contribution of diverged paths, compared with cpu-f64: t-test, {}",
            p_value(p)
        );
        Some(Held::new("bias", deviation(p), deviation(self.level), why))
    }

    fn expected<'m>(
        &self,
        e: &Expectation,
        case: &Case,
        m: &'m Measured,
        of: &dyn Fn(&str) -> Option<&'m Measured>,
    ) -> Held {
        match e {
            Expectation::Mean { value, by } => {
                // Systematic errors of f32 are added to chance; f32 has no light below 2⁻⁶⁴.
                let rounding = case.stiffness.close() * value.abs() + DARK;
                let error = m.energy.standard_error();
                let why = format!(
                    "the mean {:.7} ± {error:.1e} must be {value:.7}: {by}",
                    m.energy.mean
                );
                self.mean("energy", m.energy.mean - value, error, rounding, why)
            }
            Expectation::AtMost { value, by } => {
                // The mean is below the bound because each weight is, by the form it is computed in: no condition.
                let rounding = bound::carried(case.stiffness.vertices, 1.0) * value.abs();
                let error = m.energy.standard_error();
                let why = format!(
                    "the mean {:.7} ± {error:.1e} must be at most {value}: {by}",
                    m.energy.mean
                );
                let limit = value + rounding + deviation(self.level) * error;
                Held::new("at most", m.energy.mean, limit, why)
            }
            Expectation::SameMean { case: other, why } => match of(other) {
                None => missing(other),
                Some(o) => {
                    let error = m.energy.standard_error().hypot(o.energy.standard_error());
                    let rounding = case.stiffness.close() * o.energy.mean.abs() + DARK;
                    let why = format!(
                        "the mean {:.7} must equal that of {other}, {:.7} (± {error:.1e}): {why}",
                        m.energy.mean, o.energy.mean
                    );
                    self.mean("same", m.energy.mean - o.energy.mean, error, rounding, why)
                }
            },
            Expectation::SameBits { case: other, why } => match of(other) {
                None => missing(other),
                Some(o) => {
                    let differs = f64::from(u8::from(o.hash != m.hash));
                    Held::new(
                        "same bits",
                        differs,
                        0.0,
                        format!("every sample must equal that of {other}: {why}"),
                    )
                }
            },
            Expectation::Warning(words) => {
                let silent = f64::from(u8::from(
                    !m.warnings.iter().any(|w| w.contains(words.as_str())),
                ));
                Held::new(
                    "warning",
                    silent,
                    0.0,
                    format!("the warnings must contain “{words}”"),
                )
            }
        }
    }

    /// z-test: no larger than rounding and chance explain. For thousands of samples Student's t is normal.
    fn mean(&self, what: &'static str, off: f64, error: f64, rounding: f64, why: String) -> Held {
        Held::new(
            what,
            off.abs(),
            rounding + deviation(self.level) * error,
            why,
        )
    }
}

/// A count that must be zero.
fn sound(what: &'static str, count: u64) -> Held {
    Held::new(
        what,
        count as f64,
        0.0,
        format!("samples with {what} values, on the device or in a reference"),
    )
}

fn missing(case: &str) -> Held {
    Held::new(
        "same",
        1.0,
        0.0,
        format!("case {case}, with which it is compared, does not exist"),
    )
}

/// The z whose two-sided probability is p.
fn deviation(p: f64) -> f64 {
    Normal::standard().inverse_cdf(1.0 - p.clamp(f64::MIN_POSITIVE, 1.0) / 2.0)
}

/// The largest number of `n` events of probability `share` that chance explains with at least `level`; `None` if all `n`
/// are allowed.
fn most_of(n: u64, share: f64, level: f64) -> Option<u64> {
    let distribution = Binomial::new(share, n).ok().filter(|_| share < 1.0)?;
    // P(X > k) falls with k.
    let (mut low, mut high) = (0, n);
    while low < high {
        let k = low + (high - low) / 2;
        if distribution.sf(k) < level {
            high = k
        } else {
            low = k + 1
        }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P(X > 0) = 1 − (1 − p)ⁿ, and the normal deviate of 5 %.
    #[test]
    fn limits_are_those_of_the_distributions() {
        assert_eq!(most_of(1000, 1e-9, 1e-4), Some(0));
        assert_eq!(most_of(1000, 1e-6, 1e-4), Some(1));
        assert_eq!(most_of(1000, 1.0, 1e-4), None);
        let k = most_of(10_000, 1e-3, 1e-3).expect("a limit");
        // Poisson of mean 10: P(X > 20) = 1.59e-3, P(X > 21) = 7.0e-4.
        assert_eq!(k, 21);
        assert!((deviation(0.05) - 1.959_964).abs() < 1e-6);
    }
}

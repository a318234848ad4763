//! Holds what was measured against the case's bounds.

use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, Normal};

use super::bound;
use super::case::{Case, Expectation};
use super::measure::Measured;
use crate::check::report::Held;
use vkpt::metrics::paired::{DARK, Verdict};

/// Probability that a renderer without fault fails a battery.
pub const ALPHA: f64 = 1e-3;

/// What cases are judged by.
#[derive(Clone, Copy, Debug)]
pub struct Judge {
    /// The device rounds as the reference does: a CPU driver.
    pub correctly_rounded: bool,
    /// Level of each statistical statement.
    pub level: f64,
}

impl Judge {
    /// For a battery of `cases`: 1 − (1 − α)^(1/n) for n statements (Šidák 1967): of each case whether as many part as may,
    /// whether they do so without bias, and what is expected of it.
    pub fn new<'a>(cases: impl Iterator<Item = &'a Case>, correctly_rounded: bool) -> Self {
        let statements: usize = cases.map(|case| 2 + case.expectations.len()).sum();
        let level = 1.0 - (1.0 - ALPHA).powf(1.0 / statements.max(1) as f64);
        Self {
            correctly_rounded,
            level,
        }
    }

    /// Everything that the case is held against; `of` has what other cases came to.
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
            [self.parted(case, m), self.close(case, m), self.bias(m)]
                .into_iter()
                .flatten(),
        );
        if let Some((most, why)) = &case.weight {
            let limit = most * (1.0 + case.stiffness.close());
            held.push(Held::new(
                "weight",
                m.largest,
                limit,
                format!("no path may bring more than {most}: {why}"),
            ));
        }
        held.extend(
            case.expectations
                .iter()
                .map(|e| self.expected(e, case, m, of)),
        );
        held
    }

    /// On a CPU driver the device equals cpu-f32.
    fn bits(&self, m: &Measured) -> Option<Held> {
        let unequal = (m.f32.paths - m.f32.equal) as f64;
        let why = "paths that differ from cpu-f32 in a bit, on a device that rounds as it does";
        self.correctly_rounded
            .then(|| Held::new("bits", unequal, 0.0, why))
    }

    /// No more paths part than a binomial distribution of the bound lets through.
    fn parted(&self, case: &Case, m: &Measured) -> Option<Held> {
        let share = case.stiffness.parted();
        let limit = most_of(m.f64.paths, share, self.level)?;
        let s = &case.stiffness;
        let why = format!(
            "paths that part from cpu-f64: {} vertices × 4 decisions × 128 roundings × condition {} × 2⁻²⁴ = {share:.1e} \
             of them may, {limit} by chance; {}",
            s.vertices, s.decisions, s.why
        );
        Some(Held::new(
            "parted",
            (m.f64.paths - m.f64.together) as f64,
            limit as f64,
            why,
        ))
    }

    fn close(&self, case: &Case, m: &Measured) -> Option<Held> {
        let s = &case.stiffness;
        let why = format!(
            "relative difference to cpu-f64 that 99 % of the paths stay below: {} vertices × 128 roundings × condition {} \
             × 2⁻²⁴; {}",
            s.vertices, s.light, s.why
        );
        let p99 = m.f64.closeness.quantile(0.99)?;
        Some(Held::new("99 %", p99, s.close(), why))
    }

    /// What paths that part bring has the same mean on both sides.
    fn bias(&self, m: &Measured) -> Option<Held> {
        let p = match m.f64.parted.verdict() {
            Verdict::TooFew => return None,
            Verdict::Unbiased(p) | Verdict::Biased(p) => p,
        };
        let why =
            format!("the mean of what parted paths bring, against cpu-f64's: t-test, p = {p:.1e}");
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
                // What f32 may do to every sample alike comes on top of chance; it knows no light below 2⁻⁶⁴.
                let rounding = case.stiffness.close() * value.abs() + DARK;
                let error = m.energy.standard_error();
                let why = format!(
                    "the mean {:.7} ± {error:.1e} is to be {value:.7}: {by}",
                    m.energy.mean
                );
                self.mean("energy", m.energy.mean - value, error, rounding, why)
            }
            Expectation::AtMost { value, by } => {
                // What keeps a mean below a bound are weights that are, each by the form it is computed in: no condition.
                let rounding = bound::carried(case.stiffness.vertices, 1.0) * value.abs();
                let error = m.energy.standard_error();
                let why = format!(
                    "the mean {:.7} ± {error:.1e} is to be at most {value}: {by}",
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
                        "the mean {:.7} is to be that of {other}, {:.7} (± {error:.1e}): {why}",
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
                        format!("every sample is to equal that of {other}: {why}"),
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
                    format!("there must be a warning of “{words}”"),
                )
            }
        }
    }

    /// z-test: no further off than rounding and chance explain. Of thousands of samples Student's t is normal.
    fn mean(&self, what: &'static str, off: f64, error: f64, rounding: f64, why: String) -> Held {
        Held::new(
            what,
            off.abs(),
            rounding + deviation(self.level) * error,
            why,
        )
    }
}

/// What there must be none of.
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
        format!("there is no case {case} to hold it against"),
    )
}

/// The z whose two-sided probability is p.
fn deviation(p: f64) -> f64 {
    Normal::standard().inverse_cdf(1.0 - p.clamp(f64::MIN_POSITIVE, 1.0) / 2.0)
}

/// The most of `n` that each happen with probability `share` before chance explains them with less than `level`; `None`
/// where all may.
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

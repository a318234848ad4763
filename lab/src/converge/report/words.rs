//! Figures as text, for both the table and the page.

use super::{ErrorRecord, ReachRecord};
use vkpt::metrics::convergence::{Figures, Interval, Metric, Reach};
use vkpt::report::human::duration;

/// A missing value.
pub const NONE: &str = "–";

/// A figure, marked if it is inconclusive.
pub fn marked(error: &ErrorRecord) -> String {
    let mark = if error.below_reference { "*" } else { "" };
    format!("{mark}{}", number(error.summary.mean.value))
}

/// Three digits.
pub fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        0.01..10.0 => format!("{x:.3}"),
        10.0..1000.0 => format!("{x:.1}"),
        _ => format!("{x:.2e}"),
    }
}

/// `2.8e-3–3.5e-3`: from the lower end to the upper.
pub fn between(i: &Interval) -> String {
    format!("{}–{}", number(i.low), number(i.high))
}

/// `-1.02 ± 0.11`
pub fn with_half_width(i: &Interval) -> String {
    format!("{:.2} ± {:.2}", i.value, 0.5 * (i.high - i.low))
}

/// The reference's own error, if known.
pub fn own(own: &Figures<Option<f64>>) -> String {
    let known = Metric::ALL
        .iter()
        .filter_map(|&(metric, name)| own.of(metric).map(|x| format!("{name} {}", number(x))));
    let known: Vec<String> = known.collect();
    match known.is_empty() {
        true => "own error unknown".to_owned(),
        false => format!("own error {}", known.join(", ")),
    }
}

/// `relMSE 1e-2 after 3.20 s`
pub fn reached(record: &ReachRecord) -> String {
    let target = record.rel_mse;
    let when = match record.reach {
        Reach::Before(seconds) => format!("within the first {}", duration(seconds)),
        Reach::At(seconds) => format!("after {}", duration(seconds)),
        Reach::Extrapolated(seconds) => format!("after about {} (extrapolated)", duration(seconds)),
        Reach::Never => "not reached".to_owned(),
    };
    format!("relMSE {target:e} {when}")
}

//! Figures in the words that the table and the page have in common.

use super::{ErrorRecord, ReachRecord};
use vkpt::metrics::convergence::{Figures, Interval, Metric, Reach};
use vkpt::report::human::duration;

/// What there is not.
pub const NONE: &str = "–";

/// A figure that says nothing is not told as if it were true.
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

/// How far a reference is from the truth itself, as far as that is known.
pub fn own(own: &Figures<Option<f64>>) -> String {
    let known = Metric::ALL
        .iter()
        .filter_map(|&(metric, name)| own.of(metric).map(|x| format!("{name} {}", number(x))));
    let known: Vec<String> = known.collect();
    match known.is_empty() {
        true => "whose own error is not known".to_owned(),
        false => format!("itself off by {}", known.join(", ")),
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

//! The ticks of a logarithmic axis, and how they are labelled.

use std::ops::Range;

/// A value on an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    pub value: f64,
    /// A power of ten.
    pub decade: bool,
    pub labelled: bool,
}

/// 1, 2, … 9 times each power of ten within the span; where there are `few` powers or less, 2 and 5 have labels too.
pub fn ticks(span: &Range<f64>, few: i32) -> Vec<Tick> {
    let powers = span.end.log10().floor() as i32 - span.start.log10().ceil() as i32 + 1;
    let few = powers <= few;
    let first = span.start.log10().floor() as i32;
    let last = span.end.log10().floor() as i32;
    let tick = |(power, digit): (i32, u8)| Tick {
        // Parsed rather than multiplied: 1e-3 is that very number.
        value: format!("{digit}e{power}").parse().unwrap_or(f64::NAN),
        decade: digit == 1,
        labelled: digit == 1 || few && (digit == 2 || digit == 5),
    };
    (first..=last)
        .flat_map(|power| (1..=9).map(move |digit| (power, digit)))
        .map(tick)
        .filter(|tick| span.contains(&tick.value))
        .collect()
}

/// The powers of ten within the span.
pub fn decades(span: Range<f64>) -> impl Iterator<Item = f64> {
    let all = ticks(&span, 0).into_iter();
    all.filter(|tick| tick.decade).map(|tick| tick.value)
}

/// `20 µs`, `5 ms`, `100 s`
pub fn seconds(value: f64) -> String {
    let (scaled, unit) = match value {
        s if s < 0.999e-3 => (s * 1e6, "µs"),
        s if s < 0.999 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    // Whole in every unit, except below a microsecond.
    if scaled < 0.999 {
        format!("{value:e} s")
    } else {
        format!("{scaled:.0} {unit}")
    }
}

/// `20`, `0.05`, `1e-3`
pub fn plain(value: f64) -> String {
    match value {
        0.009_99..9_999.0 => format!("{}", (value * 1e6).round() / 1e6),
        _ => format!("{value:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_the_round_numbers_within() {
        let few = ticks(&(0.004..0.06), 1);
        let labelled: Vec<f64> = few.iter().filter(|t| t.labelled).map(|t| t.value).collect();
        assert_eq!(labelled, [0.005, 0.01, 0.02, 0.05]);
        assert_eq!(few.len(), 6 + 5);
        let many = ticks(&(0.5..2000.0), 3);
        let labelled: Vec<f64> = many
            .iter()
            .filter(|t| t.labelled)
            .map(|t| t.value)
            .collect();
        assert_eq!(labelled, [1.0, 10.0, 100.0, 1000.0]);
        assert!(many.iter().all(|t| !t.labelled || t.decade));
    }

    #[test]
    fn labels_are_round_in_their_unit() {
        let of = [1e-7, 2e-5, 1e-3, 5e-2, 0.1, 1.0, 1e4].map(seconds);
        assert_eq!(
            of,
            [
                "1e-7 s", "20 µs", "1 ms", "50 ms", "100 ms", "1 s", "10000 s"
            ]
        );
        let of = [1e-3, 5e-3, 0.01, 0.2, 1.0, 50.0, 1e4].map(plain);
        assert_eq!(of, ["1e-3", "5e-3", "0.01", "0.2", "1", "50", "1e4"]);
    }
}

//! Two logarithmic axes: their spans, ticks and labels.

use std::ops::Range;

use plotters::coord::combinators::LogCoord;
use plotters::prelude::*;

use super::PlotError;
use super::canvas::{Canvas, Place, pixels, units};

/// Room around the data, as a factor.
const MARGIN: f64 = 1.3;

/// No axis spans less than this factor.
const LEAST: f64 = 12.0;

/// Maps seconds and errors to the sheet.
pub struct Axes<'a> {
    chart: ChartContext<'a, SVGBackend<'a>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>,
    /// Seconds, and errors.
    pub spans: [Range<f64>; 2],
    /// Left, top, right, bottom of the plot in pixels.
    pub frame: [f64; 4],
}

impl<'a> Axes<'a> {
    /// Over `frame` of a sheet of `size` pixels.
    pub fn new(
        canvas: &Canvas<'a>,
        size: Place,
        frame: [f64; 4],
        spans: [Range<f64>; 2],
    ) -> Result<Self, PlotError> {
        let [left, top, right, bottom] = frame;
        let [x, y] = spans.clone();
        let chart = ChartBuilder::on(canvas.area())
            .margin_left(units(left))
            .margin_top(units(top))
            .margin_right(units(size[0] - right))
            .margin_bottom(units(size[1] - bottom))
            .build_cartesian_2d(x.log_scale(), y.log_scale())?;
        Ok(Self {
            chart,
            spans,
            frame,
        })
    }

    /// The place of an error after some seconds, both above 0.
    pub fn place(&self, seconds: f64, error: f64) -> Place {
        pixels(self.chart.backend_coord(&(seconds, error)))
    }

    /// The part of error = √(c/seconds) that lies on the plot, if any.
    pub fn guide(&self, c: f64) -> Option<[Place; 2]> {
        let [x, y] = &self.spans;
        // error ≤ y.end from seconds = c/y.end² on, error ≥ y.start up to c/y.start².
        let from = x.start.max(c / (y.end * y.end));
        let to = x.end.min(c / (y.start * y.start));
        (from < to).then(|| [from, to].map(|s| self.place(s, (c / s).sqrt())))
    }
}

/// The span of an axis that shows all of `values`, which are above 0; 1 to 10 if there are none.
pub fn span(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), v| {
        (low.min(v), high.max(v))
    });
    if low > high {
        return 1.0..10.0;
    }
    let (low, high) = (low / MARGIN, high * MARGIN);
    let widen = (LEAST / (high / low)).max(1.0).sqrt();
    low / widen..high * widen
}

/// A value on an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    pub value: f64,
    /// A power of ten.
    pub decade: bool,
    pub labelled: bool,
}

/// 1, 2, … 9 times each power of ten within the span; with at most `few` powers, 2 and 5 have labels, too.
pub fn ticks(span: &Range<f64>, few: i32) -> Vec<Tick> {
    let powers = span.end.log10().floor() as i32 - span.start.log10().ceil() as i32 + 1;
    let few = powers <= few;
    let first = span.start.log10().floor() as i32;
    let last = span.end.log10().floor() as i32;
    let tick = |(power, digit): (i32, u8)| Tick {
        // Parsed rather than multiplied: 1e-3 is exactly that number.
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

    #[test]
    fn a_span_has_room_for_its_values() {
        let wide = span([0.3, 20.0, 5.0].into_iter());
        assert!(wide.start < 0.3 && wide.end > 20.0 && wide.end < 30.0);
        let one = span([2.0].into_iter());
        assert!((one.end / one.start - LEAST).abs() < 1e-9);
        assert!(((one.start * one.end).sqrt() - 2.0).abs() < 1e-12);
        assert_eq!(span(std::iter::empty()), 1.0..10.0);
    }
}

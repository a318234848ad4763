//! Two logarithmic axes: their spans, and the places of values.

use std::ops::Range;

use super::draw::{Place, rounded};

/// Room around the data, as a factor.
const MARGIN: f64 = 1.3;

/// No axis spans less than this factor.
const LEAST: f64 = 12.0;

/// Where seconds and errors lie on the sheet.
pub struct Axes {
    /// Seconds, and errors.
    pub spans: [Range<f64>; 2],
    /// Left, top, right, bottom of the plot in pixels.
    pub frame: [f64; 4],
}

impl Axes {
    /// The place of an error after so many seconds, both above 0.
    pub fn place(&self, seconds: f64, error: f64) -> Place {
        rounded([self.x(seconds), self.y(error)])
    }

    pub fn x(&self, seconds: f64) -> f64 {
        let [left, _, right, _] = self.frame;
        left + (right - left) * share(&self.spans[0], seconds)
    }

    pub fn y(&self, error: f64) -> f64 {
        let [_, top, _, bottom] = self.frame;
        bottom + (top - bottom) * share(&self.spans[1], error)
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

/// 0 at the start of the span, 1 at its end.
fn share(span: &Range<f64>, value: f64) -> f64 {
    (value / span.start).ln() / (span.end / span.start).ln()
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

#[cfg(test)]
mod tests {
    use super::*;

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

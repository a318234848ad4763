//! The measurements, drawn on the scales.

use super::canvas::{Marker, Place};
use super::palette::{Colour, OWN};
use super::scales::Sheet;
use super::{PlotError, Point, error};
use crate::converge::report::{Convergence, StepRecord};

impl Sheet<'_> {
    /// Lines at the references' own errors.
    pub fn own_errors(&self, own: &[f64]) -> Result<(), PlotError> {
        let [left, _, right, _] = self.axes.frame;
        for y in own.iter().map(|&own| self.height_of(own)) {
            self.canvas.line(&[[left, y], [right, y]], OWN, 1.4)?;
        }
        Ok(())
    }

    /// All lines before all points, so that no line hides a point.
    pub fn curves(&self, e: &Convergence) -> Result<Vec<Point>, PlotError> {
        let mut points = Vec::new();
        for (variant, record) in e.variants.iter().enumerate() {
            let place = |(step, s): (usize, &StepRecord)| {
                let at = self.axes.place(s.wall_s.value, error(s)?.value);
                Some(Point { variant, step, at })
            };
            let of_variant: Vec<Point> =
                record.steps.iter().enumerate().filter_map(place).collect();
            let line: Vec<Place> = of_variant.iter().map(|p| p.at).collect();
            self.canvas.line(&line, Colour::of_variant(variant), 1.6)?;
            points.extend(of_variant);
        }
        for point in &points {
            let step = &e.variants[point.variant].steps[point.step];
            self.interval(step, point)?;
            let look = (
                Marker::of_variant(point.variant),
                Colour::of_variant(point.variant),
            );
            let hollow = step.errors.rel_mse.below_reference;
            self.canvas.marker(point.at, look, hollow)?;
        }
        Ok(points)
    }

    /// From one end of the interval to the other, clipped to the plot.
    fn interval(&self, step: &StepRecord, point: &Point) -> Result<(), PlotError> {
        let Some(error) = error(step) else {
            return Ok(());
        };
        let colour = Colour::of_variant(point.variant);
        let up = &self.axes.spans[1];
        let end = |e: f64| [point.at[0], self.height_of(e.clamp(up.start, up.end))];
        let ends = [error.low, error.high];
        self.canvas.line(&ends.map(end), colour, 1.2)?;
        for e in ends.into_iter().filter(|e| up.contains(e)) {
            let [x, y] = end(e);
            self.canvas
                .line(&[[x - 3.5, y], [x + 3.5, y]], colour, 1.2)?;
        }
        Ok(())
    }

    fn height_of(&self, error: f64) -> f64 {
        self.axes.place(self.axes.spans[0].start, error)[1]
    }
}

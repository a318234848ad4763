//! The measurements, drawn on the scales.

use maud::{Markup, html};

use super::axes::Axes;
use super::draw::{Place, line, marker};
use super::palette::{Colour, OWN};
use super::shown::error;
use crate::converge::report::{Convergence, StepRecord};

/// A step of a variant, and its place in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub variant: usize,
    pub step: usize,
    pub at: Place,
}

/// Those of all steps that have a place.
pub fn points(e: &Convergence, axes: &Axes) -> Vec<Point> {
    let mut points = Vec::new();
    for (variant, record) in e.variants.iter().enumerate() {
        for (step, s) in record.steps.iter().enumerate() {
            if let Some(error) = error(s) {
                let at = axes.place(s.wall_s.value, error.value);
                points.push(Point { variant, step, at });
            }
        }
    }
    points
}

/// All lines and intervals before all markers, so that none hides a marker.
pub fn curves(e: &Convergence, axes: &Axes, points: &[Point]) -> Markup {
    let variants = || points.chunk_by(|a, b| a.variant == b.variant);
    let places = |of: &[Point]| -> Vec<Place> { of.iter().map(|point| point.at).collect() };
    let colour = |of: &[Point]| Colour::of_variant(of[0].variant);
    let step = |point: &Point| &e.variants[point.variant].steps[point.step];
    let hollow = |point: &Point| step(point).errors.rel_mse.below_reference;
    html! {
        @for of in variants() {
            (colour(of).group(html! {
                (line(&places(of), 1.6))
                @for point in of { (interval(step(point), axes)) }
            }))
        }
        @for of in variants() {
            (colour(of).group(html! {
                @for point in of { (marker(point.variant, point.at, hollow(point))) }
            }))
        }
    }
}

/// From one end of the interval to the other, as far as it lies on the plot.
fn interval(step: &StepRecord, axes: &Axes) -> Markup {
    let up = &axes.spans[1];
    let x = axes.x(step.wall_s.value);
    let ends = error(step).map(|error| [error.low, error.high]);
    let y = |e: f64| axes.y(e.clamp(up.start, up.end));
    html! {
        @if let Some([low, high]) = ends {
            (line(&[[x, y(low)], [x, y(high)]], 1.2))
            @for y in [low, high].into_iter().filter(|e| up.contains(e)).map(y) {
                (line(&[[x - 3.5, y], [x + 3.5, y]], 1.2))
            }
        }
    }
}

/// Where the references stop being references.
pub fn own_errors(own: &[f64], axes: &Axes) -> Markup {
    let [left, _, right, _] = axes.frame;
    OWN.group(html! {
        @for y in own.iter().map(|&own| axes.y(own)) { (line(&[[left, y], [right, y]], 1.4)) }
    })
}

//! Error over seconds on log–log axes, as SVG: a pure function of the record.
//!
//! The left axis has √relMSE, the error as a fraction of the picture, which falls by s^−½ for independent samples; the
//! right axis has relMSE, as in the figures. The efficiency 1/(relMSE·s) is constant along each dashed line of slope
//! −½: a curve that crosses them downwards becomes more efficient with time, one that crosses them upwards flattens.

mod axes;
mod canvas;
mod curves;
mod legend;
pub mod palette;
mod scales;

use std::ops::Range;

use plotters::drawing::DrawingAreaErrorKind;
use plotters::style::text_anchor::HPos;

pub use self::canvas::UNITS;

use self::axes::{Axes, span};
use self::canvas::{Canvas, Place, Type, document};
use self::legend::Legend;
use self::palette::{INK, MUTED};
use self::scales::Sheet;
use super::{Convergence, StepRecord, VariantRecord};
use vkpt::metrics::convergence::Interval;

/// An error of plotters.
#[derive(Debug, thiserror::Error)]
#[error("the plot: {0}")]
pub struct PlotError(#[from] DrawingAreaErrorKind<std::io::Error>);

/// The layout of a plot.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// Pixels; the height follows from it.
    pub width: f64,
    /// Whether the scene's name is above it.
    pub title: bool,
}

impl Form {
    /// A separate file.
    pub const FILE: Self = Self {
        width: 800.0,
        title: true,
    };
}

/// A drawn plot.
#[derive(Clone, Debug)]
pub struct Plot {
    pub svg: String,
    /// The points drawn on it, for tooltips.
    pub points: Vec<Point>,
}

/// A step of a variant, and its place in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub variant: usize,
    pub step: usize,
    pub at: Place,
}

/// The experiment as a plot. A step whose mean error is not above 0, which halves may produce by chance, is omitted.
///
/// # Errors
/// None are known: plotters writes to memory.
pub fn plot(experiment: &Convergence, form: Form) -> Result<Plot, PlotError> {
    let narrow = form.width < 500.0;
    let spans = spans(experiment);
    let own: Vec<f64> = own_errors(experiment, &spans[1]);
    let legend = Legend::new(experiment, !own.is_empty(), form.width);
    let top = if form.title { 44.0 } else { 14.0 };
    let inner = form.width * if narrow { 0.78 } else { 0.52 };
    let frame = [
        58.0,
        top,
        form.width - if narrow { 10.0 } else { 58.0 },
        top + inner,
    ];
    let size = [form.width, frame[3] + 54.0 + legend.height()];
    let mut drawn = String::new();
    let points = {
        let canvas = Canvas::new(&mut drawn, size)?;
        let axes = Axes::new(&canvas, size, frame, spans)?;
        let sheet = Sheet { canvas, axes };
        sheet.scales(narrow)?;
        sheet.guides()?;
        sheet.own_errors(&own)?;
        if form.title {
            let at = [frame[0], 22.0];
            sheet.canvas.text(&experiment.scene, at, TITLE)?;
        }
        legend.draw(&sheet.canvas, [frame[0], frame[3] + 62.0])?;
        sheet.curves(experiment)?
    };
    let name = format!("Error of {} over seconds", experiment.scene);
    let svg = document(&drawn, size, &name);
    Ok(Plot { svg, points })
}

const LABEL: Type = Type {
    size: 12.0,
    colour: MUTED,
    anchor: HPos::Center,
    bold: false,
    upright: false,
};
const TITLE: Type = Type {
    size: 15.0,
    colour: INK,
    anchor: HPos::Left,
    bold: true,
    upright: false,
};

/// √relMSE with its interval, if it has a logarithm; the lower end may be 0.
fn error(step: &StepRecord) -> Option<Interval> {
    let rel_mse = step.errors.rel_mse.summary.mean;
    (rel_mse.value > 0.0).then(|| rel_mse.map(|e| e.max(0.0).sqrt()))
}

/// The seconds and errors that the axes show. Ends of intervals count unless they would compress the curves.
fn spans(e: &Convergence) -> [Range<f64>; 2] {
    let steps = || e.variants.iter().flat_map(|v| &v.steps);
    let shown = steps().filter_map(|s| Some((s.wall_s.value, error(s)?)));
    let ends = |i: Interval| [i.value, i.low.max(i.value / 2.0), i.high.min(i.value * 3.0)];
    let errors = shown.clone().flat_map(|(_, error)| ends(error));
    let least = errors.clone().fold(f64::INFINITY, f64::min);
    let own = e.variants.iter().filter_map(own_error);
    let near = own.filter(|&own| own > least / 4.0);
    [
        span(shown.map(|(seconds, _)| seconds)),
        span(errors.chain(near)),
    ]
}

/// The reference's own error, as √relMSE.
fn own_error(variant: &VariantRecord) -> Option<f64> {
    let own = variant.reference.own.rel_mse?;
    (own > 0.0).then(|| own.sqrt())
}

/// Those within the span, each once.
fn own_errors(e: &Convergence, span: &Range<f64>) -> Vec<f64> {
    let within = e.variants.iter().filter_map(own_error);
    let mut own: Vec<f64> = within.filter(|own| span.contains(own)).collect();
    own.sort_by(f64::total_cmp);
    own.dedup();
    own
}

/// The experiment as an SVG file.
///
/// # Errors
/// Those of [`plot`].
pub fn svg(experiment: &Convergence) -> Result<String, PlotError> {
    Ok(plot(experiment, Form::FILE)?.svg)
}

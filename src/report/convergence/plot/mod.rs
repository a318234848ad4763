//! Error over seconds on log–log axes, as SVG: a pure function of the record.
//!
//! The left axis has √relMSE, the error as a share of the picture, which falls by s^−½ where samples are independent;
//! the right one the relMSE that the figures have. Along each dashed line of slope −½ the efficiency 1/(relMSE·s) is
//! the same: a curve that crosses them downwards gets better with time, one that crosses them upwards flattens.

mod axes;
mod canvas;
mod legend;
pub mod palette;

use std::ops::Range;

use plotters::drawing::DrawingAreaErrorKind;
use plotters::style::text_anchor::HPos;

pub use self::canvas::UNITS;

use self::axes::{Axes, Tick, plain, seconds, span, ticks};
use self::canvas::{Canvas, Marker, Place, Type, document};
use self::palette::{Colour, GRID, GUIDE, INK, MUTED, OWN};
use super::{Convergence, StepRecord, VariantRecord};
use crate::metrics::convergence::Interval;

/// What plotters could not draw.
#[derive(Debug, thiserror::Error)]
#[error("the plot: {0}")]
pub struct PlotError(#[from] DrawingAreaErrorKind<std::io::Error>);

/// How a plot is laid out.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// Pixels; the height follows.
    pub width: f64,
    /// The scene stands above it.
    pub title: bool,
}

impl Form {
    /// A file that stands by itself.
    pub const FILE: Self = Self {
        width: 800.0,
        title: true,
    };
}

/// A drawn plot.
#[derive(Clone, Debug)]
pub struct Plot {
    pub svg: String,
    /// What lies on it, for whoever points there.
    pub points: Vec<Point>,
}

/// A step of a variant, and its place in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub variant: usize,
    pub step: usize,
    pub at: Place,
}

/// The experiment as a plot. A step whose mean error is not above 0, as halves may have it by chance, has no place.
///
/// # Errors
/// None are known: plotters writes to memory.
pub fn plot(experiment: &Convergence, form: Form) -> Result<Plot, PlotError> {
    let narrow = form.width < 500.0;
    let spans = spans(experiment);
    let own: Vec<f64> = own_errors(experiment, &spans[1]);
    let legend = legend::Legend::new(experiment, !own.is_empty(), form.width);
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

/// √relMSE with its interval, where it has a logarithm; the lower end may be 0.
fn error(step: &StepRecord) -> Option<Interval> {
    let rel_mse = step.errors.rel_mse.summary.mean;
    (rel_mse.value > 0.0).then(|| rel_mse.map(|e| e.max(0.0).sqrt()))
}

/// The seconds and errors that the axes show. Ends of intervals count as far as they do not press the curves together.
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

/// What the reference itself is off by, as √relMSE.
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

struct Sheet<'a> {
    canvas: Canvas<'a>,
    axes: Axes<'a>,
}

impl Sheet<'_> {
    /// Lines across, ticks, labels and what the axes are.
    fn scales(&self, narrow: bool) -> Result<(), PlotError> {
        let [left, top, right, bottom] = self.axes.frame;
        let [across, up] = &self.axes.spans;
        for tick in ticks(across) {
            let x = self.axes.place(tick.value, up.start)[0];
            self.tick(&tick, [[x, bottom], [x, top]], [x, bottom + 17.0], seconds)?;
        }
        for tick in ticks(up) {
            let y = self.axes.place(across.start, tick.value)[1];
            self.tick(&tick, [[left, y], [right, y]], [left - 8.0, y], plain)?;
        }
        let title = Type {
            colour: INK,
            ..LABEL
        };
        let upright = Type {
            upright: true,
            ..title
        };
        let middle = [0.5 * (left + right), 0.5 * (top + bottom)];
        let canvas = &self.canvas;
        canvas.text(
            "seconds of one replicate on the wall clock",
            [middle[0], bottom + 39.0],
            title,
        )?;
        canvas.text("relative error, √relMSE", [12.0, middle[1]], upright)?;
        if !narrow {
            self.right_scale()?;
            canvas.text("relMSE", [right + 48.0, middle[1]], upright)?;
        }
        canvas.line(&[[left, top], [left, bottom], [right, bottom]], MUTED, 1.0)
    }

    /// A line across the plot at each power of ten, a short one at the rest.
    fn tick(
        &self,
        tick: &Tick,
        [from, to]: [Place; 2],
        label: Place,
        words: fn(f64) -> String,
    ) -> Result<(), PlotError> {
        if tick.decade {
            self.canvas.line(&[from, to], GRID, 1.0)?;
        }
        let length = if tick.labelled { 5.0 } else { 3.0 };
        let whole = (to[0] - from[0]).hypot(to[1] - from[1]);
        let inwards = [0, 1].map(|i| from[i] + (to[i] - from[i]) / whole * length);
        self.canvas.line(&[from, inwards], MUTED, 1.0)?;
        if !tick.labelled {
            return Ok(());
        }
        let upright = from[0] == to[0];
        let anchor = if upright { HPos::Center } else { HPos::Right };
        self.canvas
            .text(&words(tick.value), label, Type { anchor, ..LABEL })
    }

    /// The powers of ten of relMSE, the square of what the left axis has.
    fn right_scale(&self) -> Result<(), PlotError> {
        let [across, up] = &self.axes.spans;
        let right = self.axes.frame[2];
        let squares = up.start * up.start..up.end * up.end;
        for tick in ticks(&squares).iter().filter(|tick| tick.decade) {
            let y = self.axes.place(across.start, tick.value.sqrt())[1];
            self.canvas
                .line(&[[right, y], [right + 5.0, y]], MUTED, 1.0)?;
            let left = Type {
                anchor: HPos::Left,
                ..LABEL
            };
            self.canvas
                .text(&plain(tick.value), [right + 9.0, y], left)?;
        }
        Ok(())
    }

    /// Lines of slope −½ through the plot, a power of ten of efficiency apart.
    fn guides(&self) -> Result<(), PlotError> {
        let [across, up] = &self.axes.spans;
        let least = up.start * up.start * across.start;
        let most = up.end * up.end * across.end;
        for tick in ticks(&(least..most)).iter().filter(|tick| tick.decade) {
            if let Some(line) = self.axes.guide(tick.value) {
                self.canvas.line(&line, GUIDE, 1.0)?;
            }
        }
        Ok(())
    }

    /// Where the references stop being references.
    fn own_errors(&self, own: &[f64]) -> Result<(), PlotError> {
        let [left, _, right, _] = self.axes.frame;
        for y in own.iter().map(|&own| self.height_of(own)) {
            self.canvas.line(&[[left, y], [right, y]], OWN, 1.4)?;
        }
        Ok(())
    }

    /// All lines before all points, so that no line hides one.
    fn curves(&self, e: &Convergence) -> Result<Vec<Point>, PlotError> {
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

    /// From one end of the interval to the other, as far as it lies on the plot.
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

/// The experiment as an SVG file.
///
/// # Errors
/// Those of [`plot`].
pub fn svg(experiment: &Convergence) -> Result<String, PlotError> {
    Ok(plot(experiment, Form::FILE)?.svg)
}

//! Error over seconds on log–log axes, as SVG: a pure function of the record.
//!
//! The left axis has √relMSE, the error as a fraction of the picture, which falls by s^−½ for independent samples; the
//! right axis has relMSE, as in the figures. The efficiency 1/(relMSE·s) is constant along each dashed line of slope
//! −½: a curve that crosses them downwards becomes more efficient with time, one that crosses them upwards flattens.

mod axes;
mod curves;
mod draw;
mod legend;
pub mod palette;
mod scales;
mod shown;
mod ticks;

use maud::{Markup, html};

pub use self::curves::Point;

use self::axes::Axes;
use self::curves::{curves, own_errors, points};
use self::draw::{Place, text};
use self::legend::Legend;
use self::palette::{INK, PAPER};
use self::scales::{guides, scales};
use super::Convergence;

/// The size of letters in pixels.
const FONT: f64 = 12.0;

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
    /// The content of an `svg` element.
    pub drawn: Markup,
    /// Width and height in pixels.
    pub size: Place,
    /// The points on it, for the pointer.
    pub points: Vec<Point>,
}

/// The experiment as a plot. A step whose mean error is not above 0, as halves may have it by chance, has no place.
pub fn plot(e: &Convergence, form: Form) -> Plot {
    let narrow = form.width < 500.0;
    let spans = shown::spans(e);
    let own = shown::own_errors(e, &spans[1]);
    let legend = Legend::new(e, !own.is_empty(), form.width);
    let left = 58.0;
    let top = if form.title { 44.0 } else { 14.0 };
    let right = form.width - if narrow { 10.0 } else { 58.0 };
    let bottom = top + (form.width * if narrow { 0.78 } else { 0.52 }).round();
    let size = [form.width, bottom + 54.0 + legend.height()];
    let frame = [left, top, right, bottom];
    let axes = Axes { spans, frame };
    let points = points(e, &axes);
    let drawn = html! {
        rect.paper width="100%" height="100%" fill=(PAPER.light) {}
        g font-family="sans-serif" font-size=(FONT) stroke-linejoin="round" {
            (scales(&axes, narrow))
            (guides(&axes))
            (own_errors(&own, &axes))
            @if form.title {
                g font-size="15" font-weight="bold" { (INK.group(text(&e.scene, [left, 22.0], "start"))) }
            }
            (legend.draw([left, bottom + 62.0]))
            (curves(e, &axes, &points))
        }
    };
    Plot {
        drawn,
        size,
        points,
    }
}

impl Plot {
    /// The `viewBox` of its `svg` element.
    pub fn view(&self) -> String {
        format!("0 0 {} {}", self.size[0], self.size[1])
    }
}

/// The plot's name for those who do not see it.
pub fn name(e: &Convergence) -> String {
    format!("Error of {} over seconds", e.scene)
}

/// The experiment as an SVG file.
pub fn svg(e: &Convergence) -> String {
    let plot = plot(e, Form::FILE);
    let [width, height] = plot.size;
    let document = html! {
        svg xmlns="http://www.w3.org/2000/svg" role="img" width=(width) height=(height) viewBox=(plot.view()) {
            title { (name(e)) }
            (plot.drawn)
        }
    };
    // XML has no place for other controls (Extensible Markup Language 1.0, section 2.2).
    document.into_string().replace(char::is_control, "�") + "\n"
}

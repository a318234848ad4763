//! The legend of the plot's lines and markers.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Marker, Place, Type};
use super::palette::{Colour, GUIDE, INK, MUTED, OWN};
use super::{LABEL, PlotError};
use crate::converge::report::{Convergence, VariantRecord};

/// Entries in columns of one width.
pub struct Legend {
    entries: Vec<Entry>,
    columns: usize,
    column: f64,
}

struct Entry {
    look: Look,
    text: String,
}

#[derive(Clone, Copy)]
enum Look {
    Variant(usize),
    /// An inconclusive point.
    Hollow,
    Line(Colour),
}

/// Between two lines of text.
const LINE: f64 = 20.0;
/// Width of the sample before the text.
const SAMPLE: f64 = 34.0;

impl Legend {
    /// For a plot of `width` pixels, with the references' own errors if `own`. A single variant needs no name.
    pub fn new(e: &Convergence, own: bool, width: f64) -> Self {
        let mut entries: Vec<Entry> = Vec::new();
        let mut add = |look, text: &str| {
            let text = text.to_owned();
            entries.push(Entry { look, text });
        };
        for (i, variant) in e.variants.iter().enumerate() {
            match variant.name.as_str() {
                "" => add(Look::Variant(i), "mean, 95 % interval"),
                name => add(Look::Variant(i), name),
            }
        }
        let hollow = |v: &VariantRecord| v.steps.iter().any(|s| s.errors.rel_mse.below_reference);
        if e.variants.iter().any(hollow) {
            add(Look::Hollow, "within the reference’s own error");
        }
        if own {
            add(Look::Line(OWN), "the reference’s own error");
        }
        add(Look::Line(GUIDE), "slope −½: equal efficiency");
        // No font is available to measure: letters of common fonts are about half as wide as high.
        let longest = entries.iter().map(|entry| entry.text.chars().count()).max();
        let column = SAMPLE + 0.54 * LABEL.size * longest.unwrap_or(0) as f64 + 18.0;
        let columns = ((width - 68.0) / column).floor().max(1.0) as usize;
        Self {
            entries,
            columns,
            column,
        }
    }

    pub fn height(&self) -> f64 {
        self.entries.len().div_ceil(self.columns) as f64 * LINE + 6.0
    }

    /// From `at`, the top left.
    pub fn draw(&self, canvas: &Canvas, at: Place) -> Result<(), PlotError> {
        let words = Type {
            colour: INK,
            anchor: HPos::Left,
            ..LABEL
        };
        for (i, entry) in self.entries.iter().enumerate() {
            let x = at[0] + (i % self.columns) as f64 * self.column;
            let y = at[1] + (i / self.columns) as f64 * LINE;
            entry.look.draw(canvas, [x, y])?;
            canvas.text(&entry.text, [x + SAMPLE, y], words)?;
        }
        Ok(())
    }
}

impl Look {
    fn draw(self, canvas: &Canvas, [x, y]: Place) -> Result<(), PlotError> {
        let line = [[x, y], [x + 26.0, y]];
        let middle = [x + 13.0, y];
        match self {
            Self::Line(colour) => canvas.line(&line, colour, 1.4),
            Self::Hollow => canvas.marker(middle, (Marker::Circle, MUTED), true),
            Self::Variant(i) => {
                let colour = Colour::of_variant(i);
                canvas.line(&line, colour, 1.6)?;
                canvas.marker(middle, (Marker::of_variant(i), colour), false)
            }
        }
    }
}

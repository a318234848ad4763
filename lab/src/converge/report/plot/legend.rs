//! The legend of the plot's lines and markers.

use maud::{Markup, html};

use super::FONT;
use super::draw::{Place, line, marker, text, translate};
use super::palette::{Colour, GUIDE, INK, MUTED, OWN};
use crate::converge::report::{Convergence, VariantRecord};

/// Entries in columns of one width.
pub struct Legend {
    /// A sample, drawn from 0,0 to the right, and its label.
    entries: Vec<(Markup, String)>,
    columns: usize,
    column: f64,
}

/// Between two lines of text.
const LINE: f64 = 20.0;
/// Width of the sample before the text.
const SAMPLE: f64 = 34.0;

impl Legend {
    /// For a plot of `width` pixels, with the references' own errors if `own`. A single variant needs no name.
    pub fn new(e: &Convergence, own: bool, width: f64) -> Self {
        let sample = |width| line(&[[0.0, 0.0], [26.0, 0.0]], width);
        let middle = [13.0, 0.0];
        let of_variant = |(i, variant): (usize, &VariantRecord)| {
            let look = html! { (sample(1.6)) (marker(i, middle, false)) };
            let name = match variant.name.as_str() {
                "" => "mean, 95 % interval",
                name => name,
            };
            (Colour::of_variant(i).group(look), name.to_owned())
        };
        let mut entries: Vec<_> = e.variants.iter().enumerate().map(of_variant).collect();
        let mut add = |look, words: &str| entries.push((look, words.to_owned()));
        let hollow = |v: &VariantRecord| v.steps.iter().any(|s| s.errors.rel_mse.below_reference);
        if e.variants.iter().any(hollow) {
            let look = MUTED.group(marker(0, middle, true));
            add(look, "within the reference’s own error");
        }
        if own {
            add(OWN.group(sample(1.4)), "the reference’s own error");
        }
        add(GUIDE.group(sample(1.4)), "slope −½: equal efficiency");
        // No font is at hand to be measured: a letter of the usual ones is about half as wide as high.
        let longest = entries.iter().map(|(_, words)| words.chars().count()).max();
        let column = SAMPLE + 0.54 * FONT * longest.unwrap_or(0) as f64 + 18.0;
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
    pub fn draw(&self, at: Place) -> Markup {
        let place = |i: usize| {
            let x = at[0] + (i % self.columns) as f64 * self.column;
            [x, at[1] + (i / self.columns) as f64 * LINE]
        };
        html! {
            @for (i, (sample, words)) in self.entries.iter().enumerate() {
                @let [x, y] = place(i);
                g transform=(translate([x, y])) { (sample) }
                (INK.group(text(words, [x + SAMPLE, y], "start")))
            }
        }
    }
}

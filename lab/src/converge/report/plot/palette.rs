//! The plot's colours. The SVG has the light ones as attributes, which every program reads; a page gives each class its
//! counterpart in the reader's theme by a rule of CSS.

use maud::{Markup, html};

/// The colour of a part of the plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// The class of its groups.
    pub name: &'static str,
    pub light: &'static str,
    pub dark: &'static str,
    /// Lengths of dashes and gaps of its lines.
    dashes: Option<&'static str>,
}

const fn colour(name: &'static str, light: &'static str, dark: &'static str) -> Colour {
    Colour {
        name,
        light,
        dark,
        dashes: None,
    }
}

/// The background.
pub const PAPER: Colour = colour("paper", "#ffffff", "#16181b");
/// Titles and axes.
pub const INK: Colour = colour("ink", "#1f2328", "#e3e6ea");
/// Labels of ticks.
pub const MUTED: Colour = colour("muted", "#57606a", "#a3abb4");
/// Lines across the plot.
pub const GRID: Colour = colour("grid", "#e6e9ec", "#2b2f34");
/// Lines of slope −½; dashed.
pub const GUIDE: Colour = Colour {
    dashes: Some("6 4"),
    ..colour("guide", "#a9b1b9", "#5e6770")
};
/// The reference's own error; dotted.
pub const OWN: Colour = Colour {
    dashes: Some("1.2 2.8"),
    ..colour("own", "#4b535c", "#bdc4cc")
};

/// The variants' colours, distinguishable by colour-blind people: those of Okabe and Ito (Color Universal Design, 2008)
/// without yellow, which is hard to see on paper; some are darkened for the same reason. From the eighth variant on
/// they repeat, with another marker.
pub const SERIES: [Colour; 7] = [
    colour("series-0", "#0066a6", "#5ab4ee"),
    colour("series-1", "#c95200", "#ff944d"),
    colour("series-2", "#008762", "#3ccfa4"),
    colour("series-3", "#b4558c", "#e89cc8"),
    colour("series-4", "#a87400", "#f0b93a"),
    colour("series-5", "#2f9bd6", "#9bd5f7"),
    colour("series-6", "#55555d", "#b9bcc6"),
];

impl Colour {
    /// Each of them once.
    pub fn all() -> impl Iterator<Item = Self> {
        [PAPER, INK, MUTED, GRID, GUIDE, OWN]
            .into_iter()
            .chain(SERIES)
    }

    /// The colour of variant `i`.
    pub fn of_variant(i: usize) -> Self {
        SERIES[i % SERIES.len()]
    }

    /// A group drawn in it.
    pub fn group(self, content: Markup) -> Markup {
        html! { g class=(self.name) color=(self.light) stroke-dasharray=[self.dashes] { (content) } }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::page::COLOURS;

    #[test]
    fn no_colour_has_two_roles() {
        let of: [fn(Colour) -> &'static str; 3] = [|c| c.name, |c| c.light, |c| c.dark];
        for of in of {
            let all: BTreeSet<&str> = Colour::all().map(of).collect();
            assert_eq!(all.len(), Colour::all().count());
        }
    }

    #[test]
    fn paper_and_ink_are_the_page_s() {
        for colour in [PAPER, INK, MUTED] {
            for value in [colour.light, colour.dark] {
                assert!(COLOURS.contains(&format!("--{}: {value};", colour.name)));
            }
        }
    }
}

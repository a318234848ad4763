//! Lines, markers and words of an SVG, in the colour of the group that they are in.

use maud::{Markup, html};

use super::palette::PAPER;

/// A place in CSS pixels from the top left.
pub type Place = [f64; 2];

/// To a tenth of a pixel, which nobody sees.
pub fn rounded(place: Place) -> Place {
    place.map(|pixels| (10.0 * pixels).round() / 10.0)
}

/// The value of a `transform` that moves 0,0 there.
pub fn translate(place: Place) -> String {
    let [x, y] = rounded(place);
    format!("translate({x} {y})")
}

/// Through all of `points`.
pub fn line(points: &[Place], width: f64) -> Markup {
    let pair = |&point: &Place| rounded(point).map(|p| p.to_string()).join(",");
    let points: Vec<String> = points.iter().map(pair).collect();
    html! {
        polyline points=(points.join(" ")) fill="none" stroke="currentColor" stroke-width=(width) {}
    }
}

/// Words, centred on `at` in height; `anchor` is `start`, `middle` or `end`.
pub fn text(words: &str, at: Place, anchor: &str) -> Markup {
    let [x, y] = rounded(at);
    html! { text x=(x) y=(y) dy="0.35em" text-anchor=(anchor) fill="currentColor" { (words) } }
}

/// Words centred on `at`, read from below to above.
pub fn upright(words: &str, at: Place) -> Markup {
    html! { g transform={ (translate(at)) " rotate(-90)" } { (text(words, [0.0, 0.0], "middle")) } }
}

/// Circle, square, triangle, diamond and wedge around 0,0, all of about the same area.
const SHAPES: [&str; 5] = [
    "M -4 0 a 4 4 0 1 0 8 0 a 4 4 0 1 0 -8 0 z",
    "M -3.6 -3.6 h 7.2 v 7.2 h -7.2 z",
    "M 0 -5.2 l 4.9 8.6 h -9.8 z",
    "M 0 -5.3 l 5.3 5.3 l -5.3 5.3 l -5.3 -5.3 z",
    "M 0 5.2 l 4.9 -8.6 h -9.8 z",
];

/// That of the variant `i`. There are fewer than colours and no common divisor: 35 variants differ in one or both.
/// Hollow, for a point that says nothing: the paper shows through.
pub fn marker(i: usize, at: Place, hollow: bool) -> Markup {
    let (class, fill, stroke) = match hollow {
        true => ("hollow", PAPER.light, "currentColor"),
        false => ("filled", "currentColor", PAPER.light),
    };
    html! {
        path class=(class) d=(SHAPES[i % SHAPES.len()]) transform=(translate(at))
            fill=(fill) stroke=(stroke) stroke-width="1.2" {}
    }
}

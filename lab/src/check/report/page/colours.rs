//! Colours by margin, and of differences.

use vkpt::metrics::difference_scale;

/// Upper ends of the ranges of margins, with the class whose colour `page.css` defines.
pub const BANDS: [(f64, &str); 4] = [(0.25, "q1"), (0.5, "q2"), (0.75, "q3"), (1.0, "q4")];

/// The class of margins beyond the bound.
pub const BEYOND: &str = "beyond";

/// The class of a margin.
pub fn band(margin: f64) -> &'static str {
    let band = BANDS.iter().find(|(end, _)| margin <= *end);
    band.map_or(BEYOND, |(_, class)| class)
}

/// CSS of the bar below a difference: the colours from −1 through 0 to 1.
pub fn scale() -> String {
    let colours = difference_scale(33)
        .into_iter()
        .map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}"));
    let colours: Vec<String> = colours.collect();
    format!(
        ".bar {{ background: linear-gradient(to right, {}); }}\n",
        colours.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_margin_above_1_is_beyond() {
        let classes = [0.0, 0.25, 0.3, 0.6, 1.0, 1.000_001, f64::INFINITY, f64::NAN].map(band);
        assert_eq!(
            classes,
            ["q1", "q1", "q2", "q3", "q4", BEYOND, BEYOND, BEYOND]
        );
    }
}

//! Signed relative differences between two pictures of the same samples, as colours: where they differ, and which is
//! brighter.

use super::paired::DARK;
use crate::film::Film;
use crate::image::srgb;

/// Relative differences of the palest and the strongest colour, of either sign; between them the scale is logarithmic.
/// f32 represents none below 6e-8 (2⁻²⁴). The range is fixed, so that two maps can be compared.
pub const DIFFERENCE_RANGE: [f64; 2] = [1e-8, 1.0];

/// (a − b)/max(|a|, |b|, [`DARK`]) of the channel in which that is largest: in [−1, 1] for radiances of one sign, 0 if
/// they are equal, NaN if one is not finite.
pub fn signed_difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    let of = |c: usize| (a[c] - b[c]) / a[c].abs().max(b[c].abs()).max(DARK);
    let larger = |x: f64, y: f64| {
        if x.is_nan() || x.abs() >= y.abs() {
            x
        } else {
            y
        }
    };
    // ∞/∞ is NaN, and a NaN counts as largest.
    larger(larger(of(0), of(1)), of(2))
}

/// Each difference as a colour. The PNG of the film at exposure 0 has exactly the colours of [`difference_colour`].
pub fn difference_map(width: u32, height: u32, differences: &[f64]) -> Film {
    let linear = |code: u8| srgb::linear(f64::from(code) / 255.0) as f32;
    let colours = differences
        .iter()
        .map(|&d| difference_colour(d).map(linear));
    Film {
        width,
        height,
        rgb: colours.collect(),
    }
}

/// sRGB codes: red for positive values, blue for negative ones, nearly white for 0 (RdBu of ColorBrewer, which
/// colour-blind people can distinguish too), black for NaN.
pub fn difference_colour(difference: f64) -> [u8; 3] {
    if difference.is_nan() {
        return [0; 3];
    }
    let [low, high] = DIFFERENCE_RANGE.map(f64::log10);
    // The logarithm of 0 is −∞, which is clamped like everything below the range.
    let size = (difference.abs().log10() - low) / (high - low);
    let place = 0.5 - 0.5 * size.clamp(0.0, 1.0).copysign(difference);
    let code = colorous::RED_BLUE.eval_continuous(place);
    [code.r, code.g, code.b]
}

/// `count` colours from a difference of −1 over 0 to 1, evenly spaced on the scale of [`DIFFERENCE_RANGE`].
pub fn difference_scale(count: usize) -> Vec<[u8; 3]> {
    let [low, high] = DIFFERENCE_RANGE.map(f64::log10);
    let last = count.saturating_sub(1).max(1) as f64;
    let colour = |i: usize| {
        let place = 2.0 * i as f64 / last - 1.0;
        let size = 10f64.powf(low + (high - low) * place.abs());
        difference_colour(size.copysign(place))
    };
    (0..count).map(colour).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_channel_that_differs_most_counts_with_its_sign() {
        let grey = [1.0; 3];
        assert_eq!(signed_difference(grey, grey), 0.0);
        assert_eq!(signed_difference([1.0, 0.5, 1.0], [1.25, 1.0, 1.0]), -0.5);
        assert_eq!(signed_difference([1.0, 1.0, 4.0], [1.25, 1.0, 1.0]), 0.75);
        assert_eq!(signed_difference([0.0; 3], [0.0; 3]), 0.0);
        // Both are dark.
        assert!(signed_difference([1e-30; 3], [0.0; 3]) < 1e-9);
        for broken in [f64::NAN, f64::INFINITY] {
            for c in 0..3 {
                let mut a = [2.0; 3];
                a[c] = broken;
                assert!(signed_difference(a, grey).is_nan(), "{broken}, {c}");
                assert!(signed_difference(grey, a).is_nan(), "{broken}, {c}");
            }
        }
    }

    #[test]
    fn colours_show_sign_and_size() {
        let scale = difference_scale(5);
        assert_eq!(scale[0], difference_colour(-1.0));
        assert_eq!(scale[2], difference_colour(0.0));
        assert_eq!(scale[4], difference_colour(1.0));
        assert_eq!(scale[3], difference_colour(1e-4));
        let [red, _, blue] = difference_colour(1e-3);
        assert!(red > blue, "red is above 0");
        let [red, _, blue] = difference_colour(-1e-3);
        assert!(red < blue, "blue is below 0");
        // One rounding step of f32 is visible; smaller differences are not.
        assert_ne!(difference_colour(6e-8), difference_colour(0.0));
        assert_eq!(difference_colour(1e-9), difference_colour(0.0));
        assert_eq!(difference_colour(7.0), difference_colour(1.0));
        assert_eq!(difference_colour(f64::NAN), [0; 3]);
    }
}

//! The perceived difference of two colours (FLIP, colour pipeline).

use std::sync::LazyLock;

use rayon::prelude::*;

use super::colour;
use super::plane::{Opponent, Plane};

/// The exponent that compresses large differences of colour: q_c.
const COMPRESSION: f64 = 0.7;
/// Differences below p_c · (the largest) are mapped to [0, p_t], those above to [p_t, 1].
const P_C: f64 = 0.4;
const P_T: f64 = 0.95;

/// The largest compressed difference: between the blue and the green of sRGB.
static LARGEST: LazyLock<f64> = LazyLock::new(|| {
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|rgb| hunt(colour::lab(rgb)));
    hyab(green, blue).powf(COMPRESSION)
});

/// The difference of two filtered pictures of one size, in [0, 1].
pub fn map(test: &Opponent, reference: &Opponent) -> Plane {
    let largest = *LARGEST;
    let error = |i: usize| {
        let [a, b] = [test, reference].map(|picture| perceived(picture, i));
        redistributed(hyab(a, b).powf(COMPRESSION), largest)
    };
    Plane {
        width: test.y.width,
        values: (0..test.y.values.len())
            .into_par_iter()
            .map(error)
            .collect(),
    }
}

/// The Hunt-adjusted CIELAB of a filtered pixel; filtering may leave the screen's gamut.
fn perceived(picture: &Opponent, i: usize) -> [f64; 3] {
    let [y, cx, cz] = [&picture.y, &picture.cx, &picture.cz].map(|plane| plane.values[i]);
    let rgb = colour::rgb([y, cx, cz]).map(|v| v.clamp(0.0, 1.0));
    hunt(colour::lab(rgb))
}

/// The Hunt effect: darker colours look less colourful.
fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    // a_h = 0.01 L* a*, b_h = 0.01 L* b*
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// A distance for very different colours (Abasi, Tehran and Fairchild, Distance metrics for very large color
/// differences, 2020).
fn hyab([l0, a0, b0]: [f64; 3], [l1, a1, b1]: [f64; 3]) -> f64 {
    // |ΔL| + √(Δa² + Δb²)
    (l0 - l1).abs() + ((a0 - a1) * (a0 - a1) + (b0 - b1) * (b0 - b1)).sqrt()
}

/// A compressed difference in [0, 1]: the range of the frequent small ones is widened.
fn redistributed(error: f64, largest: f64) -> f64 {
    let knee = P_C * largest;
    if error < knee {
        // p_t/(p_c c_max) · ΔE
        P_T / knee * error
    } else {
        // p_t + (ΔE − p_c c_max)/(c_max − p_c c_max) · (1 − p_t)
        P_T + (error - knee) / (largest - knee) * (1.0 - P_T)
    }
}

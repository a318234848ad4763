//! The error of a picture by location: relMSE of each pixel as a colour.

use super::{Pair, relative_squared_errors};
use crate::film::Film;
use crate::image::srgb;

/// relMSE of the darkest and the brightest colour; between them the scale is logarithmic. The range is fixed, so that
/// two maps can be compared.
pub const HEATMAP_RANGE: [f64; 2] = [1e-6, 1.0];

/// Each pixel's relative squared error on the scale of [`HEATMAP_RANGE`], in magma (Smith and van der Walt, the default
/// colour maps of Matplotlib 2.0). The PNG of the film at exposure 0 has exactly the colours of the map.
pub fn heatmap(pair: &Pair) -> Film {
    Film {
        rgb: relative_squared_errors(pair)
            .into_iter()
            .map(colour)
            .collect(),
        ..*pair.test()
    }
}

/// A row of `width` pixels from one end of [`HEATMAP_RANGE`] to the other, for a legend.
pub fn heatmap_scale(width: u32) -> Film {
    let [low, high] = HEATMAP_RANGE.map(f64::log10);
    let last = f64::from(width.saturating_sub(1).max(1));
    let at = |i: u32| colour(10f64.powf(low + (high - low) * f64::from(i) / last));
    Film {
        width,
        height: 1,
        rgb: (0..width).map(at).collect(),
    }
}

fn colour(error: f64) -> [f32; 3] {
    let [low, high] = HEATMAP_RANGE.map(f64::log10);
    // The logarithm of 0 is −∞, which is clamped like everything below the range.
    let t = (error.log10() - low) / (high - low);
    let code = colorous::MAGMA.eval_continuous(t.clamp(0.0, 1.0));
    [code.r, code.g, code.b].map(|c| srgb::linear(f64::from(c) / 255.0) as f32)
}

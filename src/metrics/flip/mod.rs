//! LDR-FLIP: the difference that an eye sees when two pictures alternate on a screen (Andersson, Nilsson,
//! Akenine-Möller, Oskarsson, Åström and Fairchild, FLIP: A Difference Evaluator for Alternating Images, HPG 2020;
//! below: FLIP).
//!
//! Colours are blurred as by the eye (`contrast`) and compared in a perceptual space (`colour_error`); edges and
//! points that only one picture has (`features`) amplify the difference.

mod colour;
mod colour_error;
mod contrast;
mod features;
mod plane;

use rayon::prelude::*;

use super::{MetricsError, Pair};
use crate::film::Film;
use crate::image::srgb;
use plane::{Opponent, Plane};

/// The viewing conditions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewing {
    /// Stops by which radiance is scaled before it is mapped to the codes of a PNG.
    pub exposure: f64,
    /// Pixels of the screen per degree of the eye's field, 1 to 1000.
    pub pixels_per_degree: f64,
}

impl Default for Viewing {
    /// Exposure 0, and FLIP's standard screen: 3840 pixels on 0.7 m, seen from 0.7 m: 67.02 pixels per degree.
    fn default() -> Self {
        Self {
            exposure: 0.0,
            pixels_per_degree: pixels_per_degree(0.7, 3840.0, 0.7),
        }
    }
}

/// Pixels per degree of a screen seen from its middle axis; both lengths in the same unit.
pub fn pixels_per_degree(distance: f64, pixels_across: f64, screen_width: f64) -> f64 {
    // p = d · (w_px/w_m) · π/180 (FLIP, on its parameters)
    distance * (pixels_across / screen_width) * (std::f64::consts::PI / 180.0)
}

/// The difference in each pixel, row 0 at the top.
#[derive(Clone, Debug, PartialEq)]
pub struct FlipMap {
    pub width: u32,
    pub height: u32,
    /// In [0, 1].
    pub errors: Vec<f64>,
}

impl FlipMap {
    pub fn mean(&self) -> f64 {
        self.errors.iter().sum::<f64>() / self.errors.len() as f64
    }
}

/// FLIP of two pictures as displayed from their PNGs: 8 bit sRGB at the exposure. Differences smaller than one code
/// vanish.
pub fn flip(pair: &Pair, viewing: &Viewing) -> Result<FlipMap, MetricsError> {
    let &Viewing {
        exposure,
        pixels_per_degree,
    } = viewing;
    if !(1.0..=1000.0).contains(&pixels_per_degree) {
        return Err(MetricsError::PixelsPerDegree(pixels_per_degree));
    }
    let test = opponent(pair.test(), exposure);
    let reference = opponent(pair.reference(), exposure);
    let colour = colour_error::map(
        &contrast::filter(&test, pixels_per_degree),
        &contrast::filter(&reference, pixels_per_degree),
    );
    let feature = features::map(&test.y, &reference.y, pixels_per_degree);
    Ok(FlipMap {
        width: pair.test().width,
        height: pair.test().height,
        errors: colour.zip(&feature, combine).values,
    })
}

/// A feature difference f amplifies the colour difference c; f = 1 gives the largest difference.
fn combine(c: f64, f: f64) -> f64 {
    // ΔE = ΔE_c^(1 − ΔE_f) (FLIP, final difference)
    c.powf(1.0 - f)
}

/// The opponent colours of the 8-bit codes in a PNG of the film.
fn opponent(film: &Film, exposure: f64) -> Opponent {
    let scale = exposure.exp2();
    let linear: Vec<f64> = (0..=255u8)
        .map(|code| srgb::linear(f64::from(code) / 255.0))
        .collect();
    let shown = |radiance: f32| linear[usize::from(srgb::quantise(f64::from(radiance) * scale))];
    let pixels: Vec<[f64; 3]> = film
        .rgb
        .par_iter()
        .map(|pixel| colour::opponent(pixel.map(shown)))
        .collect();
    let channel = |c: usize| Plane {
        width: film.width as usize,
        values: pixels.iter().map(|pixel| pixel[c]).collect(),
    };
    Opponent {
        y: channel(0),
        cx: channel(1),
        cz: channel(2),
    }
}

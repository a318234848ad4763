//! The differences of four groups of a pixel's samples, in pairs. Twin of `shaders/film/film_quarters.glsl`.

use super::pixel_sum::is_summable;
use crate::reference::math::{Real, Vec3};

/// Σ ± sample over the samples of even, and of odd index: + for the last of them, − for the one before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmQuarters<F> {
    pub even: Vec3<F>,
    pub odd: Vec3<F>,
}

impl<F: Real> Default for FilmQuarters<F> {
    fn default() -> Self {
        Self {
            even: Vec3::zero(),
            odd: Vec3::zero(),
        }
    }
}

/// Adds sample number `n`, counted from 1, of index `n` − 1. A broken one counts as 0, as in the film.
pub fn film_quarters<F: Real>(quarters: &mut FilmQuarters<F>, radiance: Vec3<F>, n: u32) {
    let x = if is_summable(radiance) {
        radiance
    } else {
        Vec3::zero()
    };
    let odd = n & 1 == 0;
    quarters.even = if odd {
        quarters.even
    } else {
        x - quarters.even
    };
    quarters.odd = if odd { x - quarters.odd } else { quarters.odd };
}

//! The moments of one pixel's samples, from which the standard error of their mean follows.
//! Twin of `shaders/film/film_moments.glsl`.

use super::pixel_sum::{PixelSum, film_add, is_summable};
use crate::reference::math::{Real, Vec3, vec3};

/// Mean and Σ (x − mean)² of the samples so far, per channel. Stored next to the film, whose sum they never touch, and
/// like it in two parts each: a plain `f32` would stagnate after some million samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmMoments<F> {
    pub mean: PixelSum<F>,
    pub m2: PixelSum<F>,
}

impl<F: Real> Default for FilmMoments<F> {
    fn default() -> Self {
        Self {
            mean: PixelSum::zero(),
            m2: PixelSum::zero(),
        }
    }
}

/// Adds sample number `n`, counted from 1; a broken one counts as 0, as in the film.
///
/// Samples that are all equal leave `m2` exactly 0. In `f32`, u = 2⁻²⁴, with A the largest sample, D the largest
/// difference of two, σ² = `m2` / `n` and `n` ≤ 10⁷:
///
/// - the mean that the next delta is taken from is off by less than E = 3u (A + D): the second part of the mean, uA,
///   omitted twice, and two roundings of a delta, each divided by its `n`;
/// - so `m2` has a relative error below 2√2 E/σ + (E/σ)² + 6u: Σ |delta| ≤ √(2 `n` `m2`) by Cauchy and Schwarz, and
///   three roundings of each product in addition to those of the sums. It does not grow with `n`.
///
/// Squared deviations must be representable in `f32`: deviations are to be between 1e-18 and 1e18.
pub fn film_moments<F: Real>(moments: &mut FilmMoments<F>, radiance: Vec3<F>, n: u32) {
    let x = if is_summable(radiance) {
        radiance
    } else {
        Vec3::zero()
    };
    // delta = x − mean; mean += delta / n; m2 += delta (x − mean): Welford, Technometrics 4, 1962;
    // Knuth, The Art of Computer Programming 2, 4.2.2, (15) and (16)
    let delta = x - moments.mean.sum;
    moments.mean = film_add(moments.mean, delta / F::from_u32(n));
    moments.m2 = film_add(moments.m2, delta * (x - moments.mean.sum));
}

/// The standard error of the mean of `n` ≥ 2 samples, in their unit.
///
/// Presumes that the samples are independent, which is true of [`Sampler::Random`](crate::settings::Sampler): every
/// pixel, sample and dimension draws its own random numbers. It would be too large for Sobol points: their error is
/// estimated from two groups of them ([`film_half_difference`](super::film_half_difference)).
pub fn film_stderr<F: Real>(moments: &FilmMoments<F>, n: u32) -> Vec3<F> {
    // s²/n with the unbiased s² = Σ (x − mean)² / (n − 1)
    let variance = moments.m2.sum / (F::from_u32(n) * F::from_u32(n - 1));
    vec3(variance.x.sqrt(), variance.y.sqrt(), variance.z.sqrt())
}

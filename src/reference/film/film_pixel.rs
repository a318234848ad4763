//! A pixel of the film: the sum of its samples, and what was counted on the way. Twin of `shaders/film/film_pixel.glsl`.

use super::pixel_sum::{PixelSum, film_add};
use crate::reference::math::finite::is_finite3;
use crate::reference::math::{Real, Vec3};

/// What a pixel has gathered.
#[derive(Clone, Copy, Debug)]
pub struct FilmPixel<F> {
    pub sum: PixelSum<F>,
    /// Samples dropped for a NaN.
    pub nan: u64,
    /// Samples dropped for an infinity.
    pub infinite: u64,
    pub rays: u64,
    /// Paths that reached the bounce from which even lossless ones may end.
    pub long_paths: u64,
}

impl<F: Real> Default for FilmPixel<F> {
    fn default() -> Self {
        Self {
            sum: PixelSum::zero(),
            nan: 0,
            infinite: 0,
            rays: 0,
            long_paths: 0,
        }
    }
}

/// Whether a component is not a number.
pub fn has_nan<F: Real>(v: Vec3<F>) -> bool {
    v.x.is_nan() || v.y.is_nan() || v.z.is_nan()
}

/// Adds a sample; a broken one counts as 0, and by its cause.
pub fn film_sample<F: Real>(pixel: &mut FilmPixel<F>, radiance: Vec3<F>) {
    let broken = !is_finite3(radiance);
    let nan = has_nan(radiance);
    pixel.nan += u64::from(nan);
    pixel.infinite += u64::from(broken && !nan);
    let x = if broken { Vec3::zero() } else { radiance };
    pixel.sum = film_add(pixel.sum, x);
}

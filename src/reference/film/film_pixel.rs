//! A pixel of the film: the sum of its samples, and its counters. Twin of `shaders/film/film_pixel.glsl`.

use super::pixel_sum::{PixelSum, film_add, film_mean, is_summable};
use crate::reference::math::finite::has_nan;
use crate::reference::math::{Real, Vec3, max_component};
use crate::sample::GROUPS;

// One alternating sum is enough for two groups.
const _: () = assert!(GROUPS == 2);

/// The accumulated samples of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct FilmPixel<F> {
    pub sum: PixelSum<F>,
    /// Samples complete.
    pub samples: u32,
    /// Σ ± sample: + for the last, − for the one before, alternating. It is about as large as the noise of the sum,
    /// however many samples there are, so a plain sum is accurate enough.
    pub contrast: Vec3<F>,
    /// Samples dropped because they were NaN.
    pub nan: u64,
    /// Samples dropped because they were infinite or could add up to infinity.
    pub infinite: u64,
    pub rays: u64,
    /// Paths that reached the bounce from which even lossless ones may end.
    pub long_paths: u64,
    /// Paths that ended because their throughput was below the least that the scalar can represent.
    pub underflows: u64,
    /// The brightest channel of all samples. A mean over RGB or a luminance would hide fireflies of one colour.
    pub largest: F,
    /// The index of the first sample with that channel.
    pub largest_sample: u32,
}

impl<F: Real> Default for FilmPixel<F> {
    fn default() -> Self {
        Self {
            sum: PixelSum::zero(),
            samples: 0,
            contrast: Vec3::zero(),
            nan: 0,
            infinite: 0,
            rays: 0,
            long_paths: 0,
            underflows: 0,
            largest: F::zero(),
            largest_sample: 0,
        }
    }
}

/// Adds a sample. One that is broken, or too large to add up, counts as 0, and is counted by its cause. Samples of even
/// and of odd index are the two groups ([`GROUPS`]).
pub fn film_sample<F: Real>(pixel: &mut FilmPixel<F>, radiance: Vec3<F>) {
    let broken = !is_summable(radiance);
    let nan = has_nan(radiance);
    pixel.nan += u64::from(nan);
    pixel.infinite += u64::from(broken && !nan);
    let x = if broken { Vec3::zero() } else { radiance };
    pixel.sum = film_add(pixel.sum, x);
    pixel.contrast = x - pixel.contrast;
    let brightest = max_component(x);
    if brightest > pixel.largest {
        pixel.largest = brightest;
        pixel.largest_sample = pixel.samples;
    }
    pixel.samples += 1;
}

/// A number whose square is an unbiased estimate of the variance of the mean of `n` ≥ 2 samples: half the difference of
/// the two groups' means, (a − b)/2, if they are equally large.
///
/// For even `n` the groups must be independent and of one distribution; the samples within a group may depend on each
/// other, as points of a sequence do. For odd `n` the samples must be independent too; for a sequence the estimate is
/// on average at least (n − 1)/(n + 1) and at most (n + 1)/(n − 1) of the variance.
pub fn film_half_difference<F: Real>(sum: PixelSum<F>, contrast: Vec3<F>, n: u32) -> Vec3<F> {
    // Groups of n₀ = ⌈n/2⌉ and n₁ = ⌊n/2⌋ samples of variance σ² and D = Σ ± x: for even n, Var D = n σ², so
    // D²/n² has the expectation σ²/n. For odd n, D − x̄ has the mean 0 and the variance σ² (n² − 1)/n, and
    // (D − x̄)²/(n² − 1) that expectation. If the groups' sums have the variances V₀ and V₁, the mean has (V₀ + V₁)/n²,
    // and the estimate [(n − 1)² V₀ + (n + 1)² V₁]/(n² (n² − 1)): between (n − 1)/(n + 1) and (n + 1)/(n − 1) of that.
    let odd = n & 1;
    let count = F::from_u32(n);
    let scale = (count * count - F::from_u32(odd)).sqrt();
    let expected = film_mean(sum, n) * F::from_u32(odd);
    (contrast - expected) / scale
}

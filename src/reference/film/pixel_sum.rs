//! The sum of one pixel's samples, which keeps counting where a plain `f32` sum stagnates.

use crate::reference::math::{Real, Vec3};

/// A sum in two parts: `sum` is the whole rounded to the scalar, `comp` the rounding error.
///
/// In `f32` that makes 48 bits. The samples are added one at a time, in the order of their index, so the picture does
/// not depend on how the work was sliced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSum<F> {
    pub sum: Vec3<F>,
    pub comp: Vec3<F>,
}

impl<F: Real> PixelSum<F> {
    /// The sum of no samples.
    pub fn zero() -> Self {
        Self {
            sum: Vec3::zero(),
            comp: Vec3::zero(),
        }
    }
}

/// Whether every component is below 2⁹⁶ (in f64 2⁹⁹²): 2³² of them, the most that a pixel may have, add up to less than
/// 2¹²⁸ (2¹⁰²⁴), where the scalar ends.
pub fn is_summable<F: Real>(x: Vec3<F>) -> bool {
    let below = |x: F| x.abs() < F::SUMMABLE;
    below(x.x) && below(x.y) && below(x.z)
}

/// The sum with one more sample, summable and ≥ −sum/2 in each channel. Relative error of an addition: below 3·2⁻⁴⁸.
pub fn film_add<F: Real>(pixel: PixelSum<F>, x: Vec3<F>) -> PixelSum<F> {
    // s + err = sum + x exactly: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B (2Sum)
    let s = pixel.sum + x;
    let y = s - pixel.sum;
    let err = (pixel.sum - (s - y)) + (x - y);
    // Both parts normalised again, or comp would itself stagnate at 2²⁴: sum + comp = s + low exactly, |s| ≥ |low|:
    // Dekker, A Floating-Point Technique, 1971 (Fast2Sum)
    let low = pixel.comp + err;
    let sum = s + low;
    PixelSum {
        sum,
        comp: low - (sum - s),
    }
}

/// The mean of `n` samples, `n` ≥ 1. `comp` is less than half a unit of `sum` and does not change it.
pub fn film_mean<F: Real>(pixel: PixelSum<F>, n: u32) -> Vec3<F> {
    pixel.sum / F::from_u32(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::math::vec3;

    fn add_all(from: f32, samples: impl Iterator<Item = f32>) -> PixelSum<f32> {
        let mut pixel = PixelSum::zero();
        pixel.sum.x = from;
        for x in samples {
            pixel = film_add(pixel, vec3(x, 2.0 * x, 0.0));
        }
        pixel
    }

    /// Both parts of the first channel, exact.
    fn total(pixel: PixelSum<f32>) -> f64 {
        f64::from(pixel.sum.x) + f64::from(pixel.comp.x)
    }

    #[test]
    fn ones_keep_counting_past_two_to_the_24() {
        let n = (1u32 << 24) + 1001;
        let pixel = add_all(0.0, std::iter::repeat_n(1.0, n as usize));
        assert_eq!(total(pixel), f64::from(n));
        assert_eq!(pixel.sum.y.f64() + pixel.comp.y.f64(), 2.0 * f64::from(n));
        assert_eq!(film_mean(pixel, n), vec3(1.0, 2.0, 0.0));
    }

    #[test]
    fn ones_keep_counting_at_two_to_the_25_and_40() {
        for start in [25, 40] {
            let pixel = add_all(2f32.powi(start), std::iter::repeat_n(1.0, 100_001));
            assert_eq!(total(pixel), 2f64.powi(start) + 100_001.0);
        }
    }

    /// Samples k·2⁻³², k a 24-bit word shifted by 0 … 31, and their exact sum.
    fn fireflies(n: u32) -> (Vec<f32>, u128) {
        let mut exact = 0u128;
        let samples = (0..n).map(|i| {
            let [a, b, _, _] = crate::reference::sampler::random::sampler_block(0, i, 0, 0);
            let k = u64::from(a >> 8) << (b >> 27);
            exact += u128::from(k);
            k as f32 * 2f32.powi(-32)
        });
        (samples.collect(), exact)
    }

    #[test]
    fn sums_of_uneven_samples_are_exact_to_the_bound() {
        let n = 1_000_000;
        let (samples, exact) = fireflies(n);
        let exact = exact as f64 * 2f64.powi(-32);
        let bound = f64::from(n) * 3.0 * 2f64.powi(-48) * exact;
        let pixel = add_all(0.0, samples.iter().copied());
        assert!((total(pixel) - exact).abs() <= bound);
        // the mean is the sum's rounding and one division away: one unit
        let mean = f64::from(film_mean(pixel, n).x);
        assert!(
            (mean / (exact / f64::from(n)) - 1.0).abs() <= bound / exact + f64::from(f32::EPSILON)
        );
        // a plain sum fails the comparison
        let plain: f32 = samples.iter().sum();
        assert!((f64::from(plain) - exact).abs() > bound);
    }
}

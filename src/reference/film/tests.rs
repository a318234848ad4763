//! Moments compared with two passes in f64, and with sums done by hand.

use super::{FilmMoments, FilmPixel, film_half_difference, film_moments, film_sample, film_stderr};
use crate::reference::math::{Vec3, vec3};
use crate::reference::sampler::random::sampler_block;
use crate::reference::sampler::unit_float;

/// Σ (x − mean)², and the error allowed for it, from the bound of [`film_moments`].
struct Exact {
    m2: f64,
    error: f64,
}

/// By two passes in f64.
fn two_passes(samples: &[f32]) -> Exact {
    let n = samples.len() as f64;
    let of = |f: &dyn Fn(f64) -> f64| samples.iter().map(|&x| f(x.into())).sum::<f64>();
    let mean = of(&|x| x) / n;
    let m2 = of(&|x| (x - mean).powi(2));
    let largest = samples.iter().copied().fold(0.0, f32::max);
    let least = samples.iter().copied().fold(f32::MAX, f32::min);
    let u = f32::EPSILON / 2.0;
    let e = f64::from(3.0 * u * (2.0 * largest - least)) / (m2 / n).sqrt();
    Exact {
        m2,
        error: m2 * (8f64.sqrt() * e + e * e + 6.0 * f64::from(u)),
    }
}

fn moments(samples: impl Iterator<Item = f32>) -> FilmMoments<f32> {
    let mut moments = FilmMoments::default();
    for (x, n) in samples.zip(1..) {
        film_moments(&mut moments, vec3(x, 2.0 * x, 0.0), n);
    }
    moments
}

/// Σ x² − (Σ x)²/n, which cancels.
fn textbook(samples: &[f32]) -> f64 {
    let sum: f32 = samples.iter().sum();
    let squares: f32 = samples.iter().map(|x| x * x).sum();
    f64::from(squares - sum * sum / samples.len() as f32)
}

const N: u32 = 1 << 18;

fn samples(x: impl Fn(u32, f32) -> f32) -> Vec<f32> {
    let sample = |i| x(i, unit_float(sampler_block(0, i, 0, 0)[0]));
    (0..N).map(sample).collect()
}

#[test]
fn the_squares_are_those_of_two_passes_in_f64() {
    let firefly = |at: u32| samples(move |i, u| if i == at { 1e6 } else { u });
    let rows = [
        ("uniform", samples(|_, u| u)),
        ("offset 2^12", samples(|_, u| 4096.0 + u)),
        ("offset 2^16", samples(|_, u| 65_536.0 + u)),
        ("two values", samples(|i, _| (i % 2) as f32)),
        ("rare", samples(|_, u| if u < 1e-4 { 1000.0 } else { 0.0 })),
        (
            "many sizes",
            samples(|i, u| u * 2f32.powi(i as i32 % 60 - 30)),
        ),
        ("a firefly first", firefly(0)),
        ("a firefly amid", firefly(N / 2)),
        ("a firefly last", firefly(N - 1)),
    ];
    for (name, samples) in rows {
        let exact = two_passes(&samples);
        let ours = moments(samples.iter().copied());
        let off = (f64::from(ours.m2.sum.x) - exact.m2).abs();
        assert!(
            off <= exact.error,
            "{name}: {off:e} of {:e}, granted {:e}",
            exact.m2,
            exact.error
        );
        // twice the sample: four times the square, to the bit
        assert_eq!(ours.m2.sum.y, 4.0 * ours.m2.sum.x, "{name}");
        // the formula that cancels fails the comparison
        if name.starts_with("offset") {
            assert!(
                (textbook(&samples) - exact.m2).abs() > exact.error,
                "{name}"
            );
        }
    }
}

#[test]
fn squares_keep_adding_up_past_two_to_the_24() {
    // 0 and 1 alternating: Σ (x − ½)² = n/4. Each of these adds less than half a unit to a plain sum of 2²⁴ of them.
    let n = 1u32 << 25;
    let ours = moments((0..n).map(|i| (i % 2) as f32));
    let exact = f64::from(n) / 4.0;
    // The bound again, with the 2²⁵ roundings of two sums, 3·2⁻⁴⁸ each: E = 9u, in all below 64u.
    let error = 64.0 * f64::from(f32::EPSILON) / 2.0 * exact;
    assert!((f64::from(ours.m2.sum.x) - exact).abs() <= error);
    let plain = (0..n).fold(0.0f32, |sum, _| sum + 0.25);
    assert!((f64::from(plain) - exact).abs() > error);
}

#[test]
fn equal_samples_have_no_error() {
    for x in [0.1, 1.0 / 3.0, 1e-30, 1e28] {
        let ours = moments(std::iter::repeat_n(x, 1_000_003));
        assert_eq!((ours.m2.sum, ours.mean.sum.x), (Vec3::zero(), x));
        assert_eq!(film_stderr(&ours, 1_000_003), Vec3::zero());
    }
}

#[test]
fn a_broken_sample_counts_as_black() {
    let broken = moments([1.0, f32::NAN, 3.0, f32::INFINITY].into_iter());
    let black = moments([1.0, 0.0, 3.0, 0.0].into_iter());
    assert_eq!((broken.mean, broken.m2), (black.mean, black.m2));
}

#[test]
fn the_error_of_the_mean_of_four() {
    // mean 1, s² = (1 + 1 + 4 + 0)/3 = 2, s²/4 = ½; twice of each: √2
    let stderr = film_stderr(&moments([0.0, 0.0, 3.0, 1.0].into_iter()), 4);
    assert_eq!((stderr.x, stderr.z), (0.5f32.sqrt(), 0.0));
    assert_eq!(stderr.y, 2f32.sqrt());
}

/// Every sequence of n samples that are 0 or 1, each as likely: the mean of h² is their variance over n, ¼/n, for
/// equally large groups and for others.
#[test]
fn the_half_difference_squares_to_the_variance_of_the_mean() {
    for n in 2..=9u32 {
        let square = |sequence: u32| {
            let mut pixel = FilmPixel::<f64>::default();
            for i in 0..n {
                film_sample(&mut pixel, Vec3::splat(f64::from(sequence >> i & 1)));
            }
            film_half_difference(pixel.sum, pixel.contrast, n).x.powi(2)
        };
        let mean = (0..1 << n).map(square).sum::<f64>() / f64::from(1 << n);
        assert!((mean - 0.25 / f64::from(n)).abs() < 1e-14, "{n}: {mean}");
    }
}

/// An odd number of samples whose groups are all equal or cancel, the two extremes of dependence: a group of m samples,
/// each 0 or 1 as one coin falls, has the variance m²/4, one of constants 0.
#[test]
fn of_odd_numbers_of_dependent_samples_the_square_is_within_its_bounds() {
    for n in [3u32, 5, 9] {
        let (first, second) = (n.div_ceil(2), n / 2);
        let square = |coins: [f64; 2]| {
            let mut pixel = FilmPixel::<f64>::default();
            for i in 0..n {
                film_sample(&mut pixel, Vec3::splat(coins[i as usize % 2]));
            }
            film_half_difference(pixel.sum, pixel.contrast, n).x.powi(2)
        };
        // One group is the coin's, the other's samples are ½.
        let estimated = |group: usize| {
            let of = |coin| square(if group == 0 { [coin, 0.5] } else { [0.5, coin] });
            (of(0.0) + of(1.0)) / 2.0
        };
        let true_variance = |m: u32| f64::from(m * m) / 4.0 / f64::from(n * n);
        let bound = f64::from(n - 1) / f64::from(n + 1);
        let ratios = [
            estimated(0) / true_variance(first),
            estimated(1) / true_variance(second),
        ];
        assert!((ratios[0] - bound).abs() < 1e-12, "{n}: {ratios:?}");
        assert!((ratios[1] - 1.0 / bound).abs() < 1e-12, "{n}: {ratios:?}");
    }
}

#[test]
fn the_half_difference_of_two_samples_and_of_three() {
    let half_difference = |samples: &[f32]| {
        let mut pixel = FilmPixel::default();
        samples
            .iter()
            .for_each(|&x| film_sample(&mut pixel, Vec3::splat(x)));
        film_half_difference(pixel.sum, pixel.contrast, samples.len() as u32).x
    };
    assert_eq!(half_difference(&[5.0, 2.0]), -1.5);
    // (5 − 2 + 3 − 10/3)/√8
    assert_eq!(
        half_difference(&[5.0, 2.0, 3.0]),
        (6.0 - 10.0 / 3.0) / 8f32.sqrt()
    );
    assert_eq!(half_difference(&[5.0, f32::NAN]), -2.5);
}

/// If the noise is a ten-thousandth of the samples, a plain difference of two sums of 2²² samples drowns in their
/// rounding; the alternating sum does not.
#[test]
fn little_noise_of_many_samples_is_not_lost() {
    let n = 1u32 << 22;
    let mut pixel = FilmPixel::<f32>::default();
    let mut exact = 0.0f64;
    for i in 0..n {
        let x = 1.0 + 1e-4 * (unit_float::<f32>(sampler_block(0, i, 0, 0)[0]) - 0.5);
        film_sample(&mut pixel, Vec3::splat(x));
        exact = f64::from(x) - exact;
    }
    let off = (f64::from(pixel.contrast.x) / exact - 1.0).abs();
    assert!(off < 0.01, "{off:e}");
}

//! The bound on rounding, against rounding itself: it is kept, and no smaller one would be.

use vkpt::image::{Precision, rgbe, srgb};

/// The largest share of its bound that an error takes, over 100,000 pixels between `low` and `high`, which `store` rounds.
fn worst(precision: Precision, [low, high]: [f64; 2], store: impl Fn([f64; 3]) -> [f32; 3]) -> f64 {
    let mut worst = 0f64;
    for i in 0..100_000 {
        // Multiples of the golden ratio, evenly in the logarithm.
        let value = |k: f64| low * (high / low).powf((k * 0.618_033_988_749_894_9).fract());
        let written = [3.0, 3.1, 3.2].map(|k| value(k * f64::from(i)));
        let stored = store(written);
        let rounding = precision.rounding(stored).expect("a bound");
        for channel in 0..3 {
            let error = (written[channel] - f64::from(stored[channel])).abs();
            worst = worst.max(error / rounding[channel]);
        }
    }
    worst
}

#[track_caller]
fn assert_tight(worst: f64) {
    assert!((0.9..=1.0).contains(&worst), "{worst}");
}

#[test]
fn floats() {
    let single = |rgb: [f64; 3]| rgb.map(|x| x as f32);
    assert_tight(worst(Precision::Single, [1e-37, 1e38], single));
    assert_tight(worst(Precision::Single, [1e-44, 1e-39], single));
    // 11 significant bits, and none below 2⁻²⁴ (IEEE 754, binary16).
    let half = |rgb: [f64; 3]| {
        rgb.map(|x| {
            let step = (x.log2().floor() - 10.0).max(-24.0).exp2();
            ((x / step).round() * step) as f32
        })
    };
    assert_tight(worst(Precision::Half, [1e-4, 6e4], half));
    assert_tight(worst(Precision::Half, [1e-7, 5e-5], half));
}

#[test]
fn rgbe_rounded_and_truncated() {
    let nearest = |rgb: [f64; 3]| rgbe::nearest(rgb.map(|x| x as f32));
    // Half of the loss of a writer that truncates.
    let rounded = worst(Precision::Rgbe, [1e-3, 1e3], nearest);
    assert!((0.45..=0.5).contains(&rounded), "{rounded}");
    // Ward's: the largest channel is between 128 and 256 steps; fractions of a step are dropped.
    let truncated = |rgb: [f64; 3]| {
        let largest = rgb.into_iter().fold(0.0, f64::max);
        let step = (largest.log2().floor() - 7.0).exp2();
        rgb.map(|x| ((x / step).floor() * step) as f32)
    };
    assert_tight(worst(Precision::Rgbe, [1e-3, 1e3], truncated));
}

#[test]
fn srgb_codes() {
    for bits in [8, 16] {
        let most = f64::from(2u32.pow(bits) - 1);
        let code = |rgb: [f64; 3]| {
            rgb.map(|x| srgb::linear((srgb::transfer(x) * most).round() / most) as f32)
        };
        let precision = Precision::Srgb { bits: bits as u8 };
        assert_tight(worst(precision, [1e-6, 1.0], code));
    }
}

#[test]
fn a_lossy_compression_has_no_bound() {
    assert_eq!(Precision::Lossy.rounding([1.0; 3]), None);
}

//! RGBE (Ward, "Real Pixels", Graphics Gems II, 1991): three bytes m and one common exponent e.
//!
//! A channel is m · 2^(e − 136), where the largest m of a pixel is at least 128; e = 0 is black. (Radiance itself reads
//! m + ½, and truncates when it writes; every other reader that we know of uses m unchanged.)

/// The largest value, m = 255 and e = 255. Larger values are clamped to it.
pub const LARGEST: f32 = 255.0 * (1u128 << 119) as f32;

/// A pixel with no channel above this is black, as in Ward's `setcolr`.
pub const BLACK: f32 = 1e-32;

/// The pixel of the format nearest to a linear one: at most half a step away, 2⁻⁸ of the largest channel. Negative
/// values and NaN become 0.
pub fn nearest(rgb: [f32; 3]) -> [f32; 3] {
    let clamped = |channel: f32| {
        if channel > 0.0 {
            channel.min(LARGEST)
        } else {
            0.0
        }
    };
    let rgb = rgb.map(clamped);
    let largest = rgb[0].max(rgb[1]).max(rgb[2]);
    if largest <= BLACK {
        return [0.0; 3];
    }
    let step = match step(largest) {
        // The largest m would round to 256; with the next exponent it is 128.
        step if (largest / step).round() > 255.0 => 2.0 * step,
        step => step,
    };
    // Exact but for the rounding: a step is a power of 2.
    rgb.map(|channel| (channel / step).round() * step)
}

/// The distance between neighbouring values, 2^(e − 136) with 128 ≤ largest/step < 256; `largest` and its step are
/// normal numbers.
fn step(largest: f32) -> f32 {
    let power = f32::from_bits(largest.to_bits() & 0x7f80_0000);
    power / 128.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_the_format_are_kept() {
        // 128 · 2^(23 − 136) is the smallest value that is not black.
        for e in 23..=255 {
            for m in [128.0f64, 129.0, 200.0, 255.0] {
                let at = |m: f64| (m * f64::from(e - 136).exp2()) as f32;
                let pixel = [at(1.0), at(m), at(77.0)];
                assert_eq!(nearest(pixel), pixel, "{m} {e}");
            }
        }
    }

    #[test]
    fn the_rest_is_rounded_to_half_a_step() {
        // Step 2⁻⁷ from 1 to 2, computed by hand.
        let step = 1.0 / 128.0;
        assert_eq!(
            nearest([1.0, 0.49 * step, 0.51 * step]),
            [1.0, 0.0, step],
            "small channels beside a large one"
        );
        assert_eq!(nearest([1.0 + 1.4 * step; 3]), [1.0 + step; 3]);
        assert_eq!(nearest([1.0 + 1.6 * step; 3]), [1.0 + 2.0 * step; 3]);
        // Half-way between 255 and 256 steps the exponent changes, and the step with it.
        assert_eq!(
            nearest([1.0 + 127.4 * step, step, 0.0])[..2],
            [1.0 + 127.0 * step, step]
        );
        assert_eq!(
            nearest([1.0 + 127.6 * step, step, 0.0])[..2],
            [2.0, 2.0 * step]
        );
    }

    #[test]
    fn values_beyond_the_format_are_clamped() {
        assert_eq!(f64::from(LARGEST), 255.0 * 119f64.exp2());
        assert_eq!(
            nearest([f32::MAX, f32::INFINITY, 1.0]),
            [LARGEST, LARGEST, 0.0]
        );
        assert_eq!(nearest([BLACK, 1e-38, f32::from_bits(1)]), [0.0; 3]);
        assert_ne!(nearest([1.01 * BLACK; 3]), [0.0; 3]);
        assert_eq!(nearest([-1.0, f32::NAN, 0.5]), [0.0, 0.0, 0.5]);
        assert_eq!(nearest([-1.0, f32::NEG_INFINITY, f32::NAN]), [0.0; 3]);
    }
}

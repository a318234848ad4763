//! The probability with which a uniform number is below p; twin of `shaders/sampler/chance.glsl`.

use crate::reference::math::Real;

/// Uniform numbers are multiples of 2⁻²⁴ ([`unit_float`](super::unit_float)): u < `p` is true with the probability
/// ⌈p·2²⁴⌉·2⁻²⁴. From p = 2⁻¹² on that is p to within a share of 2⁻¹², and `p` is returned; for rarer events it may be
/// many times p. A division by it is then right on average, even for rare events.
pub fn chance<F: Real>(p: F) -> F {
    let drawn = -(-p * F::new(16777216.0)).floor() * F::new(5.960464477539063e-8);
    if p < F::new(0.000244140625) { drawn } else { p }
}

#[cfg(test)]
mod tests {
    use super::super::unit_float;
    use super::*;

    /// How many of the 2²⁴ uniform numbers are below p: they ascend, so the count is where p would be inserted.
    fn below(p: f32) -> u32 {
        let (mut low, mut high) = (0u32, 1 << 24);
        while low < high {
            let k = low + (high - low) / 2;
            if unit_float::<f32>(k << 8) < p {
                low = k + 1
            } else {
                high = k
            }
        }
        low
    }

    const RARE: [f32; 9] = [0.0, 1e-40, 1e-30, 1e-12, 5.9e-8, 6e-8, 1.2e-7, 1e-5, 2.4e-4];

    #[test]
    fn rare_probabilities_become_those_of_the_draw() {
        for p in RARE {
            let drawn = f64::from(below(p)) * 2f64.powi(-24);
            assert_eq!(f64::from(chance(p)), drawn, "{p:e}");
        }
        // The test can fail: p itself is not the probability of the draw.
        assert_ne!(
            f64::from(below(1e-12)) * 2f64.powi(-24),
            f64::from(1e-12f32)
        );
    }

    #[test]
    fn common_probabilities_stay_and_are_drawn_nearly_as_often() {
        for p in [
            0.000_244_140_63f32,
            0.000_244_140_65,
            1e-3,
            0.04,
            0.5,
            0.99999994,
            1.0,
        ] {
            assert_eq!(chance(p), p);
            let drawn = f64::from(below(p)) * 2f64.powi(-24);
            let share = (drawn - f64::from(p)) / f64::from(p);
            assert!((0.0..=2f64.powi(-12)).contains(&share), "{p:e}");
        }
        assert!(chance(f32::NAN).is_nan());
    }
}

//! The distance of a rounded result from the true value.

/// computed − truth| in units of the last place of an `f32` of the size of `truth`.
///
/// Infinite where one of the two is a NaN or overflows and the other does not.
pub fn ulps(computed: f32, truth: f64) -> f64 {
    // Rounds to ∞ in f32: MAX + half a unit.
    let overflow = f64::from(f32::MAX) + 2f64.powi(103);
    if truth.is_nan() || computed.is_nan() {
        return if truth.is_nan() && computed.is_nan() {
            0.0
        } else {
            f64::INFINITY
        };
    }
    if truth.abs() >= overflow || computed.is_infinite() {
        let same = truth.abs() >= overflow && f64::from(computed) == truth.signum() * f64::INFINITY;
        return if same { 0.0 } else { f64::INFINITY };
    }
    let exponent = ((truth.abs().to_bits() >> 52) as i32 - 1023).max(-126);
    (f64::from(computed) - truth).abs() * 2f64.powi(23 - exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_pairs_have_their_distance() {
        // 1 + 2⁻²³ is the next float above 1, the one below is half as far
        let ulp = 2f64.powi(-23);
        assert_eq!(ulps(1.0, 1.0), 0.0);
        assert_eq!(ulps(1.0, 1.0 + ulp), 1.0);
        assert_eq!(ulps(1f32.next_down(), 1.0), 0.5);
        assert_eq!(ulps(-3.0, -3.0 - 5.0 * ulp), 2.5);
        // a result that was flushed to 0: 3·2⁻¹⁴⁹ is three units from it
        assert_eq!(ulps(0.0, 3.0 * 2f64.powi(-149)), 3.0);
    }

    #[test]
    fn ends_are_right_or_infinitely_wrong() {
        let (inf, nan) = (f64::INFINITY, f64::NAN);
        assert_eq!(ulps(f32::INFINITY, 1e39), 0.0);
        assert_eq!(ulps(f32::NAN, nan), 0.0);
        let wrong = [
            ulps(f32::MAX, 1e39),
            ulps(f32::NAN, 1.0),
            ulps(0.0, nan),
            ulps(f32::NEG_INFINITY, inf),
        ];
        assert_eq!(wrong, [inf; 4]);
    }
}

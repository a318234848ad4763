//! The sRGB transfer function (IEC 61966-2-1), exact and piecewise.

/// The encoded value in [0, 1] of a linear one, clamped to [0, 1]; NaN becomes 0.
pub fn transfer(linear: f64) -> f64 {
    // C = 12.92 L for L ≤ 0.0031308, 1.055 L^(1/2.4) − 0.055 above
    match linear {
        l if l >= 1.0 => 1.0,
        l if l > 0.003_130_8 => 1.055 * l.powf(1.0 / 2.4) - 0.055,
        l if l > 0.0 => 12.92 * l,
        _ => 0.0,
    }
}

/// The 8-bit code nearest to the encoded value of a linear one.
pub fn quantise(linear: f64) -> u8 {
    // In [0, 255] and never NaN, so the cast is exact.
    (255.0 * transfer(linear)).round() as u8
}

/// The linear value of an encoded one in [0, 1]; the same power continues above 1.
pub fn linear(encoded: f64) -> f64 {
    // L = C/12.92 for C ≤ 0.04045, ((C + 0.055)/1.055)^2.4 above
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_comes_back_and_rounds_at_its_middle() {
        for code in 0..=255u8 {
            let c = f64::from(code);
            assert_eq!(quantise(linear(c / 255.0)), code);
            if code < 255 {
                // Codes change half-way between two encoded values; these are just to either side.
                assert_eq!(quantise(linear((c + 0.499_99) / 255.0)), code);
                assert_eq!(quantise(linear((c + 0.500_01) / 255.0)), code + 1);
            }
        }
    }

    #[test]
    fn known_values() {
        // Published pairs: middle grey 18 % is 118, a half is 188, the knee 0.0031308 is 12.92 × that.
        assert_eq!(quantise(0.18), 118);
        assert_eq!(quantise(0.5), 188);
        assert_eq!(transfer(0.003_130_8), 12.92 * 0.003_130_8);
    }

    #[test]
    fn values_that_are_no_colours_are_clamped() {
        for black in [0.0, -0.0, -1.0, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(quantise(black), 0, "{black}");
        }
        for white in [1.0, 1.000_1, 1e30, f64::INFINITY] {
            assert_eq!(quantise(white), 255, "{white}");
        }
    }
}

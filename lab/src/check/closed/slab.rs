//! R + T of a smooth absorbing slab for light along its normal.

/// R + T = F + F(1 − F)²A²/(1 − F²A²) + (1 − F)²A/(1 − F²A²), which is F + (1 − F)²A/(1 − FA): the sum over all
/// paths that are reflected k times within, of which those of even k leave on the far side.
pub fn slab(ior: f64, kt: f64, thickness: f64) -> f64 {
    let f = ((ior - 1.0) / (ior + 1.0)).powi(2);
    let a = attenuation(kt, thickness);
    f + (1.0 - f) * (1.0 - f) * a / (1.0 - f * a)
}

/// Beer's law: Kt^t.
pub fn attenuation(kt: f64, t: f64) -> f64 {
    kt.powf(t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clear_glass_loses_nothing_and_black_glass_all_but_the_surface() {
        assert!((slab(1.5, 1.0, 3.0) - 1.0).abs() < 1e-15);
        assert!((slab(1.5, 0.0, 3.0) - 0.04).abs() < 1e-15);
        // (1 − F)²A(1 + FA)/(1 − F²A²) + F with F = .04, A = .5
        let expected = 0.04 + 0.96 * 0.96 * 0.5 * 1.02 / (1.0 - 0.0004);
        assert!((slab(1.5, 0.5, 1.0) - expected).abs() < 1e-15);
    }
}

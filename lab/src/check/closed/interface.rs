//! Reflectance and transmittance of one rough interface for light along its normal.

use std::f64::consts::FRAC_PI_2;

use vkpt::settings::Distribution;

/// Nodes of the midpoint rule over u; the integrands are bounded and piecewise smooth: an error below 1e-6.
const NODES: u32 = 1 << 16;

/// Angle of the micro-normal below which a share `u` of D(m)·(m·N) lies: Walter et al. 2007, eqs. 28, 35; Phong's
/// cos θ = (1 − u)^(1/(α_p + 2)) with α_p + 2 = 2/α², as the hand-out converts widths.
fn theta_m(distribution: Distribution, width: f64, u: f64) -> f64 {
    match distribution {
        Distribution::Ggx => (width * (u / (1.0 - u)).sqrt()).atan(),
        Distribution::Beckmann => (width * (-(-u).ln_1p()).sqrt()).atan(),
        // sin θ/2 would lose nothing either; 1 − cos² = −expm1(2 ln cos)
        Distribution::Phong => (-((-u).ln_1p() * width * width).exp_m1()).sqrt().asin(),
    }
}

/// Smith's masking of a direction at angle `theta`, 0 below the horizon: eq. 34, and 27 (rational) of the same paper.
fn g1(distribution: Distribution, width: f64, theta: f64) -> f64 {
    if theta >= FRAC_PI_2 {
        return 0.0;
    }
    let tan = theta.tan();
    match distribution {
        Distribution::Ggx => 2.0 / (1.0 + (1.0 + width * width * tan * tan).sqrt()),
        Distribution::Beckmann | Distribution::Phong => {
            let a = 1.0 / (width * tan);
            if a >= 1.6 {
                1.0
            } else {
                (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a)
            }
        }
    }
}

/// Mean over micro-normals of a function of their angle.
fn mean(distribution: Distribution, width: f64, f: impl Fn(f64) -> f64) -> f64 {
    let node = |i: u32| (f64::from(i) + 0.5) / f64::from(NODES);
    let sum: f64 = (0..NODES)
        .map(|i| f(theta_m(distribution, width, node(i))))
        .sum();
    sum / f64::from(NODES)
}

/// Albedo at normal incidence where F = 1: ∫ D(m)(m·N) G1(wi) dm, wi at twice the angle of m.
pub fn mirror(distribution: Distribution, width: f64) -> f64 {
    mean(distribution, width, |m| g1(distribution, width, 2.0 * m))
}

/// R + T at normal incidence, light going from the index `from` to the index `to`: F leaves at twice the angle of m, the
/// rest at θ_m − θ_t by Snell's law.
pub fn dielectric(distribution: Distribution, width: f64, from: f64, to: f64) -> f64 {
    mean(distribution, width, |m| {
        let f = fresnel(m, from, to);
        let reflected = f * g1(distribution, width, 2.0 * m);
        let sin_t = from / to * m.sin();
        if sin_t >= 1.0 {
            return reflected;
        }
        reflected + (1.0 - f) * g1(distribution, width, (m - sin_t.asin()).abs())
    })
}

/// Reflectance of unpolarised light at angle `theta`: Fresnel's equations, (R_s + R_p)/2.
pub fn fresnel(theta: f64, from: f64, to: f64) -> f64 {
    let sin_t = from / to * theta.sin();
    if sin_t >= 1.0 {
        return 1.0;
    }
    let (ci, ct) = (theta.cos(), (1.0 - sin_t * sin_t).sqrt());
    let s = (from * ci - to * ct) / (from * ci + to * ct);
    let p = (from * ct - to * ci) / (from * ct + to * ci);
    0.5 * (s * s + p * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// GGX of width 1: ∫ 2z/(z + 1) over the upper half of directions comes to 1 − ln 2 (model.md,
    /// "Albedo of one interface").
    #[test]
    fn ggx_of_width_1_has_a_closed_form() {
        let error = mirror(Distribution::Ggx, 1.0) - (1.0 - 2f64.ln());
        assert!(error.abs() < 1e-6, "{error:e}");
    }

    #[test]
    fn smooth_interfaces_lose_nothing_and_fresnel_is_known_at_0() {
        for distribution in Distribution::EVERY {
            assert!((mirror(distribution, 1e-4) - 1.0).abs() < 1e-6);
            assert!((dielectric(distribution, 1e-4, 1.0, 1.5) - 1.0).abs() < 1e-6);
        }
        assert!((fresnel(0.0, 1.0, 1.5) - 0.04).abs() < 1e-15);
        assert_eq!(fresnel(1.0, 1.5, 1.0), 1.0);
    }
}

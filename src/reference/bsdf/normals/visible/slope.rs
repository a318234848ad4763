//! Slopes of visible micro-normals along the plane of incidence; twin of `shaders/bsdf/normals/visible/slope.glsl`.
//!
//! In units of the distribution's width, a facet of slope t towards `wo` is seen in proportion to t + limit, and the
//! slopes are distributed as a Gaussian. Their share beyond t is G(t)/G(−limit) with
//!
//! G(t) = p erfc t + r e^(−(1 − γ)t²), −dG/dt = 2/√π e^(−t²) (p + q t e^(γt²)), q = √π (1 − γ) r.
//!
//! Beckmann has γ = 0 and the limit p/q (Heitz & d'Eon, Importance Sampling Microfacet-Based BSDFs using the Distribution of
//! Visible Normals, 2014; inverted by Newton's method: Jakob, An Improved Visible Normal Sampling Routine for the Beckmann
//! Distribution, 2014); Phong has γ > 0.

use super::incidence::above_zero;
use crate::reference::math::{ErfcGauss, Real, max2, min2};

const SQRT_PI: f64 = 1.772_453_850_905_516;
const TWO_OVER_SQRT_PI: f64 = std::f64::consts::FRAC_2_SQRT_PI;
/// Beyond this many widths lie 2e-10 of a Gaussian.
const FAR: f64 = 4.5;

/// G, over t ≥ −limit.
#[derive(Clone, Copy, Debug)]
pub struct SlopeLaw<F> {
    pub p: F,
    pub r: F,
    /// In [0, 1/3].
    pub gamma: F,
    /// At least 0.
    pub limit: F,
}

/// A law whose limit is clamped to where the Gaussian is.
pub fn slope_law<F: Real>(p: F, r: F, gamma: F, limit: F) -> SlopeLaw<F> {
    SlopeLaw {
        p,
        r,
        gamma,
        limit: min2(limit, F::new(FAR)),
    }
}

/// G(t) and its parts.
#[derive(Clone, Copy, Debug)]
pub struct SlopeShare<F> {
    /// G(t)
    pub share: F,
    pub erfc: F,
    /// e^(−t²)
    pub gauss: F,
    /// q e^(γt²)
    pub tilt: F,
}

/// G(t).
pub fn slope_share<F: Real>(law: SlopeLaw<F>, t: F) -> SlopeShare<F> {
    let ErfcGauss { erfc, gauss } = F::erfc_gauss(t);
    // compilers drop this where γ is the constant 0
    let grown = if law.gamma == F::zero() {
        F::one()
    } else {
        F::exp(law.gamma * (t * t))
    };
    SlopeShare {
        share: law.p * erfc + law.r * (gauss * grown),
        erfc,
        gauss,
        tilt: F::new(SQRT_PI) * law.r * (F::one() - law.gamma) * grown,
    }
}

/// A slope near the one with G(t) = u G(−limit); `whole` is G(−limit).
///
/// Where visibility matters, it is right at both ends and where q → ∞: with s² = −ln u, t = s − limit/(1 + c s), c such
/// that 1 − G/G(−limit) begins as s² does. Elsewhere it is a Gaussian's, cut off at −limit, then moved and narrowed to
/// the first two moments of (1 + t q/p) e^(−t²); but next to a limit that is not dark, where few facets are left, it is
/// one for uniform brightness.
pub fn slope_start<F: Real>(law: SlopeLaw<F>, whole: SlopeShare<F>, u: F) -> F {
    let (one, tenth) = (F::one(), F::new(0.1));
    let s = (-F::log1p(u - one)).sqrt();
    let limit = law.limit;
    let w = F::new(SQRT_PI) * whole.erfc / whole.gauss;
    let c = w / (one + (one + limit * w).sqrt());
    let seen = s - limit / (one + c * s);
    let tilt = F::new(SQRT_PI) * law.r * (one - law.gamma) / law.p;
    let x = F::erfc_inverse(u * whole.erfc);
    let moved = x + tilt * (F::new(0.5) - F::new(0.25) * tilt * x);
    // over the density at −limit
    let dark = law.p - limit * whole.tilt;
    let rest = (one - u) * whole.share / (F::new(TWO_OVER_SQRT_PI) * whole.gauss * dark);
    let next = rest > F::zero() && rest < tenth;
    let narrow = if next {
        rest - limit
    } else {
        max2(moved, tenth - limit)
    };
    if tilt > F::new(0.4) { seen } else { narrow }
}

/// One step of Householder's method of third order (1970) from `t` towards G = `goal`: the error is raised to its
/// fourth power. −limit is not passed, nor approached or left by more than a factor of 8.
pub fn slope_step<F: Real>(law: SlopeLaw<F>, goal: F, t: F) -> F {
    let (one, two) = (F::one(), F::new(2.0));
    let at = slope_share(law, t);
    let h = law.gamma * (t * t);
    // −dG/dt √π/2 e^(t²), its first and second derivative over itself
    let seen = law.p + t * at.tilt;
    let first = at.tilt * (one + two * h) / seen;
    let second = law.gamma * at.tilt * t * (F::new(6.0) + F::new(4.0) * h) / seen;
    // Newton's step, G''/G' and G'''/G'
    let newton = (goal - at.share) / (F::new(TWO_OVER_SQRT_PI) * at.gauss * seen);
    let bent = first - two * t;
    let twisted = two * (two * t * t - one) - F::new(4.0) * t * first + second;
    let change = newton * (one - F::new(0.5) * bent * newton)
        / (one - bent * newton + twisted * newton * newton * F::new(1.0 / 6.0));
    let from_limit = t + law.limit;
    let kept = max2(t - change, F::new(0.125) * from_limit - law.limit);
    min2(
        min2(kept, F::new(8.0) * from_limit - law.limit),
        F::new(5.0),
    )
}

/// A slope that is exceeded with probability `u`, within 4e-9 of the probability, 3e-7 in f32.
pub fn slope_sample<F: Real>(law: SlopeLaw<F>, u: F) -> F {
    let whole = slope_share(law, -law.limit);
    let u = above_zero(u);
    let goal = u * whole.share;
    let t = slope_step(law, goal, slope_start(law, whole, u));
    slope_step(law, goal, slope_step(law, goal, t))
}

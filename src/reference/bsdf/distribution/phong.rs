//! Phong; twin of `shaders/bsdf/distribution/phong.glsl`. `alpha` is the exponent α_p, ≥ 0.
//!
//! With Beckmann's G1 this is no Smith pair and gains energy at small exponents: the albedo at F = 1 reaches 1.34 for
//! α_p = 0 at grazing angles, 1.25 for 1, 1.028 for 10. That is the hand-out's model; nothing is clamped.

use super::micro_normal::micro_normal;
use super::rational_g1::rational_g1;
use crate::reference::math::{Real, Vec3};

/// D = (α_p + 2)/(2π) cos^α_p θ (Walter et al. 2007, eq. 30).
///
/// ln cos θ is taken from sin² θ where that is small, ½ ln(1 − s²), and from cos θ beyond,
/// −ln(1 + (1 − z)/z): either is accurate where the other cancels.
pub fn phong_d<F: Real>(m: Vec3<F>, alpha: F) -> F {
    let s2 = m.x * m.x + m.y * m.y;
    let near = s2 < F::new(0.5);
    let x = if near { -s2 } else { (F::one() - m.z) / m.z };
    let scale = if near { F::new(0.5) } else { -F::one() };
    let d = (alpha + F::new(2.0))
        * F::new(0.5 / std::f64::consts::PI)
        * F::exp(scale * alpha * F::log1p(x));
    // 1/mz overflows for smaller mz
    if m.z > F::new(1e-30) { d } else { F::zero() }
}

/// Beckmann's rational G1 for the width √(2/(α_p + 2)).
pub fn phong_g1<F: Real>(v: Vec3<F>, width: F) -> F {
    rational_g1(v, width)
}

/// A micro-normal from D(m)·mz: cos θ = (1 − u)^(1/(α_p + 2)) (Walter et al. 2007, eq. 31; the hand-out's
/// α_p + 1 is not the density it divides by).
///
/// With e = 2 ln(1 − u)/(α_p + 2): sin² θ = 1 − exp(e), cos θ = exp(e/2).
pub fn phong_sample<F: Real>(alpha: F, u: [F; 2]) -> Vec3<F> {
    let e = F::new(2.0) * F::log1p(-u[0]) / (alpha + F::new(2.0));
    let sin_theta = (-F::expm1(e)).sqrt();
    micro_normal(sin_theta, F::exp(F::new(0.5) * e), u[1])
}

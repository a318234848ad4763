//! Beckmann; twin of `shaders/bsdf/distribution/beckmann.glsl`. `alpha` is the width, in (0, 1].

use super::micro_normal::micro_normal_at_tan2;
use super::rational_g1::rational_g1;
use crate::reference::math::{Real, Vec3};

/// D = exp(−(mx² + my²)/(mz² α²))/(π α² mz⁴) (Walter et al. 2007, eq. 25).
pub fn beckmann_d<F: Real>(m: Vec3<F>, alpha: F) -> F {
    let alpha2 = alpha * alpha;
    let s2 = m.x * m.x + m.y * m.y;
    let z2 = m.z * m.z;
    let d = F::exp(-(s2 / (z2 * alpha2))) / (F::new(std::f64::consts::PI) * alpha2 * (z2 * z2));
    // at mz = 1e-6 the exponential has long been 0, and mz⁴ does not yet vanish: 0, and not 0/0
    if m.z > F::new(1e-6) { d } else { F::zero() }
}

/// The rational G1 of width `alpha`.
pub fn beckmann_g1<F: Real>(v: Vec3<F>, alpha: F) -> F {
    rational_g1(v, alpha)
}

/// A micro-normal from D(m)·mz: tan² θ = −α² ln(1 − u) (Walter et al. 2007, eq. 28).
pub fn beckmann_sample<F: Real>(alpha: F, u: [F; 2]) -> Vec3<F> {
    micro_normal_at_tan2(-(alpha * alpha * F::log1p(-u[0])), u[1])
}

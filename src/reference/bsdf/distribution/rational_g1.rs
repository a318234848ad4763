//! Masking of Beckmann and Phong; twin of `shaders/bsdf/distribution/rational_g1.glsl`.

use crate::reference::math::{Real, Vec3};

/// The rational fit to Beckmann's G1 (Schlick 1994; Walter et al. 2007, eq. 27), within 3.1e-3 of the erf form.
///
/// `alpha` > 0 is a width, `v` of unit length on either side; the result is at least 0, and at
/// most 1.000062: the fit is above 1 from x = 1.548 on, most at 1.589.
/// x = z/(α s), z = |v.z|, s² = vx² + vy²: G1 = x(3.535 + 2.181x)/(1 + x(2.276 + 2.577x)), 1 from x = 1.6 on.
pub fn rational_g1<F: Real>(v: Vec3<F>, alpha: F) -> F {
    let z = v.z.abs();
    let s = alpha * (v.x * v.x + v.y * v.y).sqrt();
    let x = z / s;
    let fit = x * (F::new(3.535) + F::new(2.181) * x)
        / (F::one() + x * (F::new(2.276) + F::new(2.577) * x));
    // compared before the division, whose divisor is 0 for v = N
    if z >= F::new(1.6) * s { F::one() } else { fit }
}

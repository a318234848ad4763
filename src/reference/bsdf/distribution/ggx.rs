//! GGX; twin of `shaders/bsdf/distribution/ggx.glsl`. `alpha` is the width, in (0, 1].

use super::micro_normal::micro_normal_at_tan2;
use crate::reference::math::{Real, Vec3};

/// D = 1/(π α² q²), q = (mx² + my²)/α² + mz² (Walter et al. 2007, eq. 33, without its tangent).
pub fn ggx_d<F: Real>(m: Vec3<F>, alpha: F) -> F {
    let alpha2 = alpha * alpha;
    let s2 = m.x * m.x + m.y * m.y;
    let q = s2 / alpha2 + m.z * m.z;
    let d = F::one() / (F::new(std::f64::consts::PI) * alpha2 * (q * q));
    if m.z > F::zero() { d } else { F::zero() }
}

/// G1 = 2z/(z + √(z² + α² s²)), z = |v.z|, s² = vx² + vy² (Walter et al. 2007, eq. 34).
pub fn ggx_g1<F: Real>(v: Vec3<F>, alpha: F) -> F {
    let z = v.z.abs();
    let s2 = v.x * v.x + v.y * v.y;
    F::new(2.0) * z / (z + (z * z + alpha * alpha * s2).sqrt())
}

/// A micro-normal from D(m)·mz: tan² θ = α² u/(1 − u) (Walter et al. 2007, eq. 35).
pub fn ggx_sample<F: Real>(alpha: F, u: [F; 2]) -> Vec3<F> {
    micro_normal_at_tan2(alpha * alpha * u[0] / (F::one() - u[0]), u[1])
}

//! A micro-normal from its angles; twin of `shaders/bsdf/distribution/micro_normal.glsl`.

use crate::reference::math::{Real, Vec3, normalize3, vec3};

/// The micro-normal at (sin θ, cos θ) and azimuth φ = 2πu.
pub fn micro_normal<F: Real>(sin_theta: F, cos_theta: F, u: F) -> Vec3<F> {
    let (sin_phi, cos_phi) = F::sincos_2pi(u);
    normalize3(vec3(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta))
}

/// The micro-normal at tan² θ = `t2` and azimuth φ = 2πu.
///
/// cos θ = 1/√(1 + tan² θ), sin θ = tan θ cos θ: a small angle keeps all its digits.
pub fn micro_normal_at_tan2<F: Real>(t2: F, u: F) -> Vec3<F> {
    let cos_theta = F::one() / (F::one() + t2).sqrt();
    micro_normal(t2.sqrt() * cos_theta, cos_theta, u)
}

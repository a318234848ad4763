//! The diffuse lobe; twin of `shaders/bsdf/diffuse/lambert.glsl`.

use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::sample::{BsdfValue, value_if};
use crate::reference::math::{Real, Vec3, vec3};

/// A direction about N' with density cos θ/π: a disc's point lifted to the hemisphere, sin² θ = u₀, φ = 2πu₁ (Malley's
/// method: Pharr, Jakob, Humphreys, Physically Based Rendering, 3rd edition, section 13.6.3).
pub fn cosine_lobe<F: Real>(u: [F; 2]) -> Vec3<F> {
    let (sin_phi, cos_phi) = F::sincos_2pi(u[1]);
    let sin_theta = u[0].sqrt();
    vec3(
        sin_theta * cos_phi,
        sin_theta * sin_phi,
        (F::one() - u[0]).sqrt(),
    )
}

/// value·|N·wi| = Kd/π wi.z, density wi.z/π; zero on the far side.
pub fn lambert_lobe<F: Real>(at: &Interaction<F>, wi: Vec3<F>) -> BsdfValue<F> {
    let pdf = wi.z * F::new(std::f64::consts::FRAC_1_PI);
    let value = at.material.kd * pdf;
    value_if(wi.z > F::zero(), BsdfValue { value, pdf })
}

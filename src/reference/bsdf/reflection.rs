//! The reflected lobe E_r; twin of `shaders/bsdf/reflection.glsl`. Equation numbers are those of Walter et al. 2007.

use super::facet::Facet;
use super::interaction::Interaction;
use super::sample::{BsdfValue, value_if};
use super::snell::reflected_share;
use crate::reference::math::{Real, Vec3, normalize3};

/// wi = 2(wo·m)m − wo, `c` = wo·m (eq. 39; signed, unlike the hand-out's).
pub fn reflect_about<F: Real>(wo: Vec3<F>, m: Vec3<F>, c: F) -> Vec3<F> {
    m * (F::new(2.0) * c) - wo
}

/// m = normalize(wo + wi) (eq. 13)
pub fn reflection_half_vector<F: Real>(wo: Vec3<F>, wi: Vec3<F>) -> Vec3<F> {
    normalize3(wo + wi)
}

/// dω_m/dω_i = 1/(4c) (eq. 14)
pub fn reflection_jacobian<F: Real>(c: F) -> F {
    F::one() / (F::new(4.0) * c)
}

/// value·|N·wi| = D G F/(4 wo.z) (eq. 20), density pm R/(4c); zero unless c, wo.z and wi.z > 0.
pub fn reflection_lobe<F: Real>(at: &Interaction<F>, wi: Vec3<F>, x: Facet<F>) -> BsdfValue<F> {
    let value = reflected_share(at, x.c, x.f) * (F::new(0.25) * x.dg);
    let pdf = x.pm * x.p_reflect * reflection_jacobian(x.c);
    value_if(
        x.c > F::zero() && at.wo.z > F::zero() && wi.z > F::zero(),
        BsdfValue { value, pdf },
    )
}

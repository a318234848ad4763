//! The reflected lobe E_r; twin of `shaders/bsdf/reflection.glsl`.

use super::facet::Facet;
use super::interaction::Interaction;
use super::sample::{BsdfValue, no_value};
use super::snell::total_reflection;
use crate::reference::math::{Real, Vec3, normalize3};

/// wi = 2(wo·m)m − wo, `c` = wo·m (Walter et al. 2007, eq. 39; signed, unlike the hand-out's).
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

/// What the facet reflects: F, or at total reflection, where F = 1, the A(t) that absorption by `term` puts in
/// the place of E_r.
pub fn reflected_share<F: Real>(at: &Interaction<F>, c: F, f: Vec3<F>) -> Vec3<F> {
    if total_reflection(at, c) {
        at.attenuation
    } else {
        f
    }
}

/// value·|N·wi| = D G F/(4 wo.z) (eq. 20), density pm R/(4c); nothing unless c > 0 and wi.z > 0.
pub fn reflection_lobe<F: Real>(at: &Interaction<F>, wi: Vec3<F>, x: Facet<F>) -> BsdfValue<F> {
    let lobe = BsdfValue {
        value: reflected_share(at, x.c, x.f) * (F::new(0.25) * x.dg),
        pdf: x.pm * x.reflect * reflection_jacobian(x.c),
    };
    if x.c > F::zero() && wi.z > F::zero() {
        lobe
    } else {
        no_value()
    }
}

//! The refracted lobe E_t; twin of `shaders/bsdf/transmission.glsl`. Equation numbers are those of Walter et al. 2007.

use super::facet::Facet;
use super::interaction::Interaction;
use super::refraction::{bend, refracted_cosine};
use super::sample::{BsdfValue, value_if};
use super::scaling::transmission_scale;
use crate::reference::math::{Real, Vec3, normalize3};
use crate::settings::Settings;

/// m = ±normalize(eta wo + wi) with mz > 0 (eq. 16; the sign makes it right for ior < 1 too).
pub fn transmission_half_vector<F: Real>(at: &Interaction<F>, wi: Vec3<F>) -> Vec3<F> {
    let m = normalize3(at.wo * at.eta + wi);
    if m.z < F::zero() { -m } else { m }
}

/// dω_m/dω_i = |ci|/(ci + eta c)² (eq. 17), ci = wi·m
pub fn transmission_jacobian<F: Real>(at: &Interaction<F>, c: F) -> F {
    let k = bend(at, c);
    refracted_cosine(at, c) / (k * k)
}

/// Light that the facet transmits, without the Jacobian and without eta²: D G (1 − F) c/wo.z, × A(t).
pub fn transmitted<F: Real>(at: &Interaction<F>, x: Facet<F>) -> Vec3<F> {
    (Vec3::one() - x.f) * at.attenuation * (x.dg * x.c)
}

/// value·|N·wi| = D G (1 − F) c J/wo.z (eq. 21), × eta² for radiance after J, which is as small as eta⁻²; density pm (1
/// − R) J; zero unless c, wo.z > 0 and ci, wi.z < 0.
pub fn transmission_lobe<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    x: Facet<F>,
) -> BsdfValue<F> {
    let jacobian = transmission_jacobian(at, x.c);
    let value = transmitted(at, x) * jacobian * transmission_scale(settings, at.eta);
    let pdf = x.pm * (F::one() - x.p_reflect) * jacobian;
    let zero = F::zero();
    value_if(
        x.c > zero && x.ci < zero && at.wo.z > zero && wi.z < zero,
        BsdfValue { value, pdf },
    )
}

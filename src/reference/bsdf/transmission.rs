//! The refracted lobe E_t; twin of `shaders/bsdf/transmission.glsl`.

use super::facet::Facet;
use super::interaction::Interaction;
use super::sample::{BsdfValue, no_value};
use super::scaling::transmission_scale;
use super::snell::snell_radicand;
use crate::reference::math::{Real, Vec3, max2, normalize3};
use crate::settings::Settings;

/// √r = |wi·m| of the direction refracted at cosine `c` = wo·m; 0 at total reflection.
pub fn refracted_cosine<F: Real>(at: &Interaction<F>, c: F) -> F {
    max2(snell_radicand(at, c), F::zero()).sqrt()
}

/// wi·m + eta c = eta c − √r, without cancellation: −(1 − eta²)/(eta c + √r).
pub fn bend<F: Real>(at: &Interaction<F>, c: F) -> F {
    -at.one_minus_eta2 / (at.eta * c + refracted_cosine(at, c))
}

/// wi = (eta c − √r)m − eta wo (Walter et al. 2007, eq. 40), normalized; `c` = wo·m and r > 0.
pub fn refract_about<F: Real>(at: &Interaction<F>, m: Vec3<F>, c: F) -> Vec3<F> {
    normalize3(m * bend(at, c) - at.wo * at.eta)
}

/// m = ±normalize(eta wo + wi) with mz > 0 (eq. 16; the sign so that ior < 1 is right too).
pub fn transmission_half_vector<F: Real>(at: &Interaction<F>, wi: Vec3<F>) -> Vec3<F> {
    let m = normalize3(at.wo * at.eta + wi);
    if m.z < F::zero() { -m } else { m }
}

/// dω_m/dω_i = |ci|/(ci + eta c)² (eq. 17), ci = wi·m
pub fn transmission_jacobian<F: Real>(at: &Interaction<F>, c: F) -> F {
    let k = bend(at, c);
    refracted_cosine(at, c) / (k * k)
}

/// What the facet lets through, without the Jacobian: D G (1 − F) c/wo.z, × eta² for radiance, × A(t).
pub fn transmitted<F: Real>(settings: &Settings, at: &Interaction<F>, x: Facet<F>) -> Vec3<F> {
    let scale = transmission_scale(settings, at.eta);
    (Vec3::one() - x.f) * at.attenuation * (x.dg * x.c * scale)
}

/// value·|N·wi| = D G (1 − F) c J/wo.z (eq. 21), density pm (1 − R) J; nothing unless c > 0, ci < 0 and wi.z < 0.
pub fn transmission_lobe<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    x: Facet<F>,
) -> BsdfValue<F> {
    let jacobian = transmission_jacobian(at, x.c);
    let lobe = BsdfValue {
        value: transmitted(settings, at, x) * jacobian,
        pdf: x.pm * (F::one() - x.reflect) * jacobian,
    };
    if x.c > F::zero() && x.ci < F::zero() && wi.z < F::zero() {
        lobe
    } else {
        no_value()
    }
}

//! A prepared material, rounded to the scalar; in the kernels the layout's `Material` record.

use crate::prepared::{self, MaterialKind};
use crate::reference::math::{Real, Vec3};
use crate::settings::{Distribution, Fresnel};

/// See [`prepared::Material`], where each field is explained. Pairs hold the outer side first.
#[derive(Clone, Copy, Debug)]
pub struct Material<F> {
    pub kd: Vec3<F>,
    pub kd_mean: F,
    pub f0: Vec3<F>,
    pub alpha: F,
    pub sigma: Vec3<F>,
    pub width: F,
    pub radiance: Vec3<F>,
    pub p_d: F,
    pub eta: [F; 2],
    pub one_minus_eta2: [F; 2],
    pub d: [F; 2],
    pub p_r: F,
    pub kind: MaterialKind,
    pub distribution: Distribution,
    pub fresnel: Fresnel,
}

impl<F: Real> From<&prepared::Material> for Material<F> {
    fn from(m: &prepared::Material) -> Self {
        let pair = |v: [f64; 2]| v.map(F::new);
        Self {
            kd: Vec3::new(m.kd),
            kd_mean: F::new(m.kd_mean),
            f0: Vec3::new(m.f0),
            alpha: F::new(m.alpha),
            sigma: Vec3::new(m.sigma),
            width: F::new(m.width),
            radiance: Vec3::new(m.radiance),
            p_d: F::new(m.p_d),
            eta: pair(m.eta),
            one_minus_eta2: pair(m.one_minus_eta2),
            d: pair(m.d),
            p_r: F::new(m.p_r),
            kind: m.kind,
            distribution: m.distribution,
            fresnel: m.fresnel,
        }
    }
}

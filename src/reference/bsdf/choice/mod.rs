//! The choice of lobe: diffuse or not, then, once the micro-normal is known, reflection or refraction. The kernels'
//! slot `<choice>`. Densities stay computable because the first choice depends on `wo` alone.

pub mod fresnel;
pub mod norms;

use super::interaction::Interaction;
use crate::reference::math::Real;
use crate::settings::{LobeChoice, Settings};

/// Probability of the diffuse lobe; 0 without Kd.
pub fn diffuse_probability<F: Real>(settings: &Settings, at: &Interaction<F>) -> F {
    match settings.estimator.lobe {
        LobeChoice::Fresnel => fresnel::diffuse_probability(at),
        LobeChoice::Norms => norms::diffuse_probability(at),
    }
}

/// Probability R of reflection at a micro-normal of cosine `c` = wo·m and mean reflectance `f_mean`, given
/// that the diffuse lobe was not chosen. 1 for opaque materials, and for all at total reflection.
pub fn reflect_probability<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    c: F,
    f_mean: F,
) -> F {
    match settings.estimator.lobe {
        LobeChoice::Fresnel => fresnel::reflect_probability(at, c, f_mean),
        LobeChoice::Norms => norms::reflect_probability(at, c, f_mean),
    }
}

//! Reflectance of an interface; the kernels' slot `<fresnel>`.

pub mod exact;
pub mod schlick;

use super::interaction::Interaction;
use crate::reference::math::{Real, Vec3};
use crate::settings::Fresnel;

/// Reflectance per channel of a micro-normal at cosine `c` = wo·m > 0; 1 at total reflection.
pub fn fresnel<F: Real>(at: &Interaction<F>, c: F) -> Vec3<F> {
    match at.material.fresnel {
        Fresnel::Schlick => schlick::fresnel_schlick(at, c),
        Fresnel::Exact => exact::fresnel_exact(at, c),
    }
}

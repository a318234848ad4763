//! Which micro-normals are drawn, and their density; the kernels' slot `<normals>`.

pub mod distribution;
pub mod visible;

use super::interaction::Interaction;
use crate::reference::math::{Real, Vec3};
use crate::settings::{Normals, Settings};

/// A micro-normal; it may be one that `wo` cannot see, which the caller rejects.
pub fn normals_sample<F: Real>(settings: &Settings, at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    match settings.estimator.normals {
        Normals::Visible => visible::normals_sample(at, u),
        Normals::Distribution => distribution::normals_sample(at, u),
    }
}

/// Density per solid angle with which [`normals_sample`] draws `m`.
pub fn normals_pdf<F: Real>(settings: &Settings, at: &Interaction<F>, m: Vec3<F>) -> F {
    match settings.estimator.normals {
        Normals::Visible => visible::normals_pdf(at, m),
        Normals::Distribution => distribution::normals_pdf(at, m),
    }
}

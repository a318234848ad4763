//! Micro-normals from D(m)·(m·N); twin of `shaders/bsdf/normals/distribution.glsl`.

use crate::reference::bsdf::distribution::{distribution_d, distribution_sample};
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::math::{Real, Vec3};

/// A micro-normal from the material's own distribution.
pub fn normals_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    distribution_sample(&at.material, u)
}

/// D(m) mz
pub fn normals_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    distribution_d(&at.material, m) * m.z
}

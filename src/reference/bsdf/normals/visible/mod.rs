//! Micro-normals that `wo` sees, from the material's own distribution or nearly so; twin of
//! `shaders/bsdf/normals/visible.glsl` and the kernels' slot `<visible>`.
//!
//! With the choice by Fresnel, and eta² divided out, the mean over RGB of a weight is, apart from the model's own G1(wi), the
//! same for every normal of GGX and Beckmann, and that of Phong's exceeds its mean by a few percent at most (model.md, "Visible
//! micro-normals"). So products of weights along a path vary only as much as the model's energy demands.

pub mod beckmann;
pub mod ggx;
pub mod incidence;
pub mod phong;
pub mod slope;

use super::super::interaction::Interaction;
use crate::reference::math::{Real, Vec3};
use crate::settings::Distribution;

/// A micro-normal; `wo` may just fail to see it.
pub fn normals_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    visible_sample(at, u)
}

/// Density with which it is drawn: for GGX and Beckmann D_wo(m) = G1(wo) max(0, wo·m) D(m)/wo.z (Heitz 2018, eq. 3).
pub fn normals_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    visible_pdf(at, m)
}

/// A visible normal of the material's distribution.
pub fn visible_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    match at.material.distribution {
        Distribution::Phong => phong::visible_phong_sample(at, u),
        Distribution::Beckmann => beckmann::visible_beckmann_sample(at, u),
        Distribution::Ggx => ggx::visible_ggx_sample(at, u),
    }
}

/// Density per solid angle with which [`visible_sample`] draws `m`.
pub fn visible_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    match at.material.distribution {
        Distribution::Phong => phong::visible_phong_pdf(at, m),
        Distribution::Beckmann => beckmann::visible_beckmann_pdf(at, m),
        Distribution::Ggx => ggx::visible_ggx_pdf(at, m),
    }
}

//! Distributions of micro-normals and their masking, isotropic; the kernels' slot `<distribution>`.
//!
//! D(m) is per solid angle with ∫ D(m) (m·N) dm = 1, G1 Smith's masking of one direction. Nothing here forms
//! 1 − (m·N)², or calls a tangent (model.md, "Distributions and shadowing").

pub mod beckmann;
pub mod ggx;
pub mod micro_normal;
pub mod phong;
pub mod rational_g1;

use super::material::Material;
use crate::reference::math::{Real, Vec3};
use crate::settings::Distribution;

/// D(m) of the material's distribution; 0 for m.z ≤ 0.
pub fn distribution_d<F: Real>(material: &Material<F>, m: Vec3<F>) -> F {
    match material.distribution {
        Distribution::Phong => phong::phong_d(m, material.alpha),
        Distribution::Beckmann => beckmann::beckmann_d(m, material.alpha),
        Distribution::Ggx => ggx::ggx_d(m, material.alpha),
    }
}

/// G1(v) of the material's distribution, in [0, 1] except where the rational fit exceeds 1; takes |v.z|.
pub fn distribution_g1<F: Real>(material: &Material<F>, v: Vec3<F>) -> F {
    match material.distribution {
        Distribution::Phong => phong::phong_g1(v, material.width),
        Distribution::Beckmann => beckmann::beckmann_g1(v, material.width),
        Distribution::Ggx => ggx::ggx_g1(v, material.width),
    }
}

/// A micro-normal from D(m)·(m·N).
pub fn distribution_sample<F: Real>(material: &Material<F>, u: [F; 2]) -> Vec3<F> {
    match material.distribution {
        Distribution::Phong => phong::phong_sample(material.alpha, u),
        Distribution::Beckmann => beckmann::beckmann_sample(material.alpha, u),
        Distribution::Ggx => ggx::ggx_sample(material.alpha, u),
    }
}

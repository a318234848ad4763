//! Surfaces for tests.

use glam::DVec3;
use vkpt::prepared::{self, material::material};
use vkpt::reference::bsdf::{Interaction, Material, interaction};
use vkpt::reference::math::{Real, Vec3, vec3};
use vkpt::scene::Brdf;
use vkpt::settings::{Distribution, Fresnel, LobeChoice, Normals, Settings};

/// A colourless rough dielectric with exact Fresnel. `alpha` is on the scale of `distribution`.
pub fn dielectric(distribution: Distribution, alpha: f64, ior: f64) -> prepared::Material {
    let brdf = Brdf {
        kd: DVec3::ZERO,
        ks: DVec3::splat(0.04),
        alpha: width(distribution, alpha),
        kt: DVec3::ONE,
        kt_length: 1.0,
        ior,
        distribution: Some(distribution),
        fresnel: Some(Fresnel::Exact),
    };
    let mut m = material(&brdf, &Settings::default().model, 1);
    m.alpha = alpha;
    m
}

/// An opaque rough material.
pub fn opaque(distribution: Distribution, alpha: f64, kd: DVec3, ks: DVec3) -> prepared::Material {
    let brdf = Brdf {
        kd,
        ks,
        alpha: width(distribution, alpha),
        kt: DVec3::ZERO,
        kt_length: 1.0,
        ior: 1.0,
        distribution: Some(distribution),
        fresnel: None,
    };
    let mut m = material(&brdf, &Settings::default().model, 1);
    m.alpha = alpha;
    m
}

/// Width of the lobe whose parameter is `alpha`: α_p = 2/α_b² − 2.
pub fn width(distribution: Distribution, alpha: f64) -> f64 {
    match distribution {
        Distribution::Phong => (2.0 / (alpha + 2.0)).sqrt(),
        _ => alpha,
    }
}

/// The parameter of the lobe of width `width`.
pub fn parameter(distribution: Distribution, width: f64) -> f64 {
    match distribution {
        Distribution::Phong => 2.0 / (width * width) - 2.0,
        _ => width,
    }
}

/// `m` seen along `wo`, nothing absorbed.
pub fn seen<F: Real>(m: &prepared::Material, outside: bool, wo: Vec3<F>) -> Interaction<F> {
    interaction(Material::rounded(m, F::new), outside, wo, Vec3::one())
}

/// The direction at cosine `z` and azimuth `phi`.
pub fn direction(z: f64, phi: f64) -> Vec3<f64> {
    let s = ((1.0 - z) * (1.0 + z)).sqrt();
    vec3(s * phi.cos(), s * phi.sin(), z)
}

/// Default settings with this estimator.
pub fn estimator(lobe: LobeChoice, normals: Normals) -> Settings {
    let mut s = Settings::default();
    s.estimator.lobe = lobe;
    s.estimator.normals = normals;
    s
}

pub const DISTRIBUTIONS: [Distribution; 3] = Distribution::EVERY;
pub const ESTIMATORS: [(LobeChoice, Normals); 4] = [
    (LobeChoice::Fresnel, Normals::Visible),
    (LobeChoice::Fresnel, Normals::Distribution),
    (LobeChoice::Norms, Normals::Visible),
    (LobeChoice::Norms, Normals::Distribution),
];

//! The quantities that a rough reflection and a rough refraction through one micro-normal share; twin of
//! `shaders/bsdf/facet.glsl`.

use super::choice::reflect_probability;
use super::distribution::{distribution_d, distribution_g1};
use super::fresnel::fresnel;
use super::interaction::{Interaction, carried_mean};
use super::normals::normals_pdf;
use crate::reference::math::{Real, Vec3, dot3};
use crate::settings::Settings;

/// A micro-normal between `wo` and `wi`.
#[derive(Clone, Copy, Debug)]
pub struct Facet<F> {
    /// wo·m
    pub c: F,
    /// wi·m
    pub ci: F,
    /// Reflectance.
    pub f: Vec3<F>,
    /// Probability that it reflects, given that it was drawn.
    pub p_reflect: F,
    /// Density with which it is drawn.
    pub pm: F,
    /// D(m) G1(wo) G1(wi)/wo.z
    pub dg: F,
}

/// The facet `m` between at.wo and `wi`.
pub fn facet<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> Facet<F> {
    let c = dot3(at.wo, m);
    let f = fresnel(at, c);
    let g = distribution_g1(&at.material, at.wo) * distribution_g1(&at.material, wi);
    Facet {
        c,
        ci: dot3(wi, m),
        f,
        p_reflect: reflect_probability(settings, at, c, carried_mean(at, f)),
        pm: normals_pdf(settings, at, m),
        dg: distribution_d(&at.material, m) * g / at.wo.z,
    }
}

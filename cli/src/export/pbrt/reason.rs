//! Features without an equivalent in pbrt-v4.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd with Ks or Kt: pbrt can layer surfaces, but not add them")]
    Sum,
    #[error("the Phong distribution: pbrt has only GGX")]
    Phong,
    #[error("the Beckmann distribution: pbrt has only GGX")]
    Beckmann,
    #[error(
        "glass with Schlick's reflectance: pbrt's is exact, as vkpt's with `fresnel exact` in the scene or --fresnel exact"
    )]
    SchlickGlass,
    #[error(
        "Ks below 1 on an opaque surface: pbrt's metals have the reflectance of a complex index, not Schlick's"
    )]
    SchlickMetal,
    #[error("the width {0}: pbrt treats widths below 0.001 as smooth")]
    Narrow(f64),
    #[error("rough glass with an index this near 1: single precision does not resolve it in pbrt")]
    WeakGlass,
    #[error(
        "a Kt that is 0 in only one channel: pbrt converts it to a smooth spectrum, which transmits nothing"
    )]
    OpaqueChannel,
    #[error(
        "a mesh with shading normals: where they face away from the eye, pbrt uses the side of the normal and vkpt the \
         triangle's"
    )]
    ShadingNormals,
    #[error(
        "a picture of the surroundings: pbrt's is an equal-area square, whose texels are not those of latitude and longitude"
    )]
    Surroundings,
    #[error(
        "faces of this shape coincide with faces of line {0}: in pbrt rounding decides which is visible"
    )]
    Coincident(usize),
}

/// The flag whose value has no equivalent in pbrt, and why.
pub fn setting(model: &Model) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: pbrt absorbs along every segment in a medium")
    } else if !model.radiance_scaling {
        Some("--radiance-scaling off: pbrt scales radiance at each refraction")
    } else {
        None
    }
}

//! Features without an equivalent in pbrt-v4.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd beside Ks or Kt: pbrt has layers of surfaces, but adds none to another")]
    Sum,
    #[error("the Phong distribution: of vkpt's, pbrt has GGX alone")]
    Phong,
    #[error("the Beckmann distribution: of vkpt's, pbrt has GGX alone")]
    Beckmann,
    #[error(
        "glass with Schlick's reflectance: pbrt's is exact, as vkpt's is by `fresnel exact` in the scene or --fresnel exact"
    )]
    SchlickGlass,
    #[error(
        "Ks below 1 on what is opaque: pbrt's metals have the reflectance of a complex index, not Schlick's"
    )]
    SchlickMetal,
    #[error("the width {0}: pbrt takes all below 0.001 as smooth")]
    Narrow(f64),
    #[error("rough glass with an index so near 1: single precision does not resolve it in pbrt")]
    WeakGlass,
    #[error(
        "a Kt that is 0 in one channel alone: pbrt makes a smooth spectrum of it, which lets nothing through"
    )]
    OpaqueChannel,
    #[error(
        "a mesh with shading normals: where they turn away from the eye, pbrt goes by their side of the surface and vkpt by \
         the triangle's"
    )]
    ShadingNormals,
    #[error(
        "a picture of the surroundings: pbrt's is a square of equal areas, whose texels are not those of latitude and longitude"
    )]
    Surroundings,
    #[error(
        "faces of this shape and of that of line {0} are in one place: which of them is seen is left to rounding in pbrt"
    )]
    Coincident(usize),
}

/// The flag whose value has no equivalent in pbrt, and why.
pub fn setting(model: &Model) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: pbrt absorbs along every stretch in a medium")
    } else if !model.radiance_scaling {
        Some("--radiance-scaling off: pbrt scales radiance at each refraction")
    } else {
        None
    }
}

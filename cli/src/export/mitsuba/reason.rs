//! Features without an equivalent in Mitsuba.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd beside Ks or Kt: Mitsuba mixes two surfaces, but adds none to another")]
    Sum,
    #[error("the Phong distribution: of vkpt's, Mitsuba has GGX and Beckmann")]
    Phong,
    #[error(
        "the Beckmann distribution: Mitsuba draws its visible normals by another G1 than it evaluates, and converges to \
         up to 0.3 % more or less"
    )]
    Beckmann,
    #[error(
        "glass with Schlick's reflectance: Mitsuba's is exact, as vkpt's is by `fresnel exact` in the scene or --fresnel exact"
    )]
    SchlickGlass,
    #[error(
        "a smooth mirror whose Ks is below 1: Mitsuba has Schlick's reflectance on rough surfaces alone"
    )]
    SchlickMirror,
    #[error(
        "the width {0}: Mitsuba's surface with Schlick's reflectance is nowhere smoother than 0.001"
    )]
    NarrowGloss(f64),
    #[error("rough glass with an index so near 1: single precision does not resolve it in Mitsuba")]
    WeakGlass,
    #[error(
        "a mesh with shading normals: where they turn away from the eye, Mitsuba goes by their side of the surface and vkpt \
         by the triangle's"
    )]
    ShadingNormals,
    #[error("a light of a mesh that is not closed: Mitsuba's shines to one side alone")]
    OpenLight,
    #[error("the eye stands inside this light: Mitsuba's shines outwards alone")]
    EyeInLight,
    #[error(
        "a picture of the surroundings: Mitsuba blends its texels, which are of constant radiance here"
    )]
    Surroundings,
    #[error(
        "faces of this shape and of that of line {0} are in one place: which of them is seen is left to rounding in Mitsuba"
    )]
    Coincident(usize),
}

/// The flag whose value has no equivalent in Mitsuba, and why.
pub fn setting(model: &Model) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: Mitsuba absorbs along every stretch in a medium")
    } else if !model.radiance_scaling {
        Some("--radiance-scaling off: Mitsuba scales radiance at each refraction")
    } else {
        None
    }
}

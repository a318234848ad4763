//! Features without an equivalent in Mitsuba.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd with Ks or Kt: Mitsuba can mix two surfaces, but not add them")]
    Sum,
    #[error("the Phong distribution: Mitsuba has only GGX and Beckmann")]
    Phong,
    #[error(
        "the Beckmann distribution: Mitsuba samples visible normals with another G1 than it evaluates, and converges to \
         up to 0.3 % more or less"
    )]
    Beckmann,
    #[error(
        "glass with Schlick's reflectance: Mitsuba's is exact, as vkpt's with `fresnel exact` in the scene or --fresnel exact"
    )]
    SchlickGlass,
    #[error(
        "a smooth mirror whose Ks is below 1: Mitsuba has Schlick's reflectance only for rough surfaces"
    )]
    SchlickMirror,
    #[error(
        "the width {0}: Mitsuba's surface with Schlick's reflectance is limited to 0.001 and above"
    )]
    NarrowGloss(f64),
    #[error(
        "rough glass with an index this near 1: single precision does not resolve it in Mitsuba"
    )]
    WeakGlass,
    #[error(
        "a mesh with shading normals: where they face away from the eye, Mitsuba uses the side of the normal and vkpt the \
         triangle's"
    )]
    ShadingNormals,
    #[error("a light that is an open mesh: Mitsuba's emits to one side only")]
    OpenLight,
    #[error("the eye is inside this light: Mitsuba's emits only outwards")]
    EyeInLight,
    #[error(
        "a picture of the surroundings: Mitsuba interpolates its texels, which have constant radiance in vkpt"
    )]
    Surroundings,
    #[error(
        "faces of this shape coincide with faces of line {0}: in Mitsuba rounding decides which is visible"
    )]
    Coincident(usize),
}

/// The flag whose value has no equivalent in Mitsuba, and why.
pub fn setting(model: &Model) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: Mitsuba absorbs along every segment in a medium")
    } else if !model.radiance_scaling {
        Some("--radiance-scaling off: Mitsuba scales radiance at each refraction")
    } else {
        None
    }
}

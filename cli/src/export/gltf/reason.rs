//! Features without an equivalent in glTF 2.0, as vkpt reads it.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd with Kt: glTF's surfaces either scatter or transmit")]
    Sum,
    #[error("the Phong distribution: glTF has only GGX")]
    Phong,
    #[error("the Beckmann distribution: glTF has only GGX")]
    Beckmann,
    #[error(
        "glass with the exact reflectance: glTF's is Schlick's, as vkpt's with --fresnel schlick"
    )]
    ExactGlass,
    #[error("an index of refraction below 1: glTF has none")]
    ThinIndex,
    #[error("a sphere: glTF has only triangles")]
    Sphere,
    #[error("a cylinder: glTF has only triangles")]
    Cylinder,
    #[error("a vertex normal without a direction: glTF's are of length 1")]
    NoNormal,
    #[error("a lens: glTF's cameras are pinholes")]
    Lens,
    #[error(
        "a background: glTF has no surroundings; vkpt's reader uses white of radiance 1 if the file has no lights, else black"
    )]
    Background,
    #[error("no lights: vkpt's reader would use a white background")]
    Dark,
    #[error("no shapes: a glTF file needs a triangle")]
    Nothing,
    #[error("all meshes together exceed the limit of a GLB: write to a name that ends in .gltf")]
    Large,
}

/// The flag whose value has no equivalent in glTF, and why.
pub fn setting(model: &Model, crop: Option<[u32; 4]>) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: glTF's volumes absorb along every segment")
    } else if !model.radiance_scaling {
        Some(
            "--radiance-scaling off: glTF cannot express it; give the flag when rendering the file",
        )
    } else if model.max_depth.is_some() {
        Some("--max-depth: glTF cannot express it; give the flag when rendering the file")
    } else if crop.is_some() {
        Some("--crop: glTF's cameras show whole pictures; give the flag when rendering the file")
    } else {
        None
    }
}

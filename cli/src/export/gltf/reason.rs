//! Features without an equivalent in glTF 2.0 as vkpt reads it.

use vkpt::settings::{Absorption, Model};

/// The reason for a refusal.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    #[error("Kd beside Kt: glTF's surfaces scatter or transmit")]
    Sum,
    #[error("the Phong distribution: glTF has GGX alone")]
    Phong,
    #[error("the Beckmann distribution: glTF has GGX alone")]
    Beckmann,
    #[error(
        "glass with the exact reflectance: glTF's is Schlick's, as vkpt's is by --fresnel schlick"
    )]
    ExactGlass,
    #[error("an index of refraction below 1: glTF has none")]
    ThinIndex,
    #[error("a sphere: glTF has triangles alone")]
    Sphere,
    #[error("a cylinder: glTF has triangles alone")]
    Cylinder,
    #[error("a vertex normal without a direction: glTF's are of length 1")]
    NoNormal,
    #[error("a lens: glTF's cameras are pinholes")]
    Lens,
    #[error(
        "a background: glTF has no surroundings, and vkpt's reader takes white of radiance 1 where nothing shines, else black"
    )]
    Background,
    #[error("nothing shines: vkpt's reader would light it by a white background")]
    Dark,
    #[error("nothing is to be seen: a glTF file needs a triangle")]
    Nothing,
    #[error("all meshes together are larger than a GLB may be: write to a name that ends in .gltf")]
    Large,
}

/// The flag whose value has no equivalent in glTF, and why.
pub fn setting(model: &Model, crop: Option<[u32; 4]>) -> Option<&'static str> {
    if model.absorption == Absorption::Term {
        Some("--absorption term: glTF's volumes absorb along every stretch")
    } else if !model.radiance_scaling {
        Some(
            "--radiance-scaling off: glTF says nothing of it; give the flag where the file is rendered",
        )
    } else if model.max_depth.is_some() {
        Some("--max-depth: glTF says nothing of it; give the flag where the file is rendered")
    } else if crop.is_some() {
        Some("--crop: glTF's cameras see whole pictures; give the flag where the file is rendered")
    } else {
        None
    }
}

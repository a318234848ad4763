//! Everything that both renderers share, computed once in f64: σ, eta, world-space vertices, shape frames, light
//! tables, the eye's medium.
//!
//! Positions and lengths are in rendering space ([`Space`]): the scene moved so that the middle of its bounds is the
//! origin, and scaled to about 1, which keeps f32 accurate at any position and scale of the scene.

mod aims;
pub mod cdf;
mod coincide;
mod dark;
mod eye;
mod lens;
mod light_tree;
mod lights;
pub mod material;
mod medium;
mod meeting;
mod memory;
pub mod patch;
mod placed;
mod prepare;
mod range;
pub mod record;
mod surroundings;

use glam::DVec3;

pub use crate::layout::constants::none::NONE;
pub use crate::scene::WordLines;
pub use crate::shape::{
    Bounds, Coincidence, Coincidences, Cuboid, Cylinder, LightKind, Primitives, ShapeKind, Space,
    Sphere, Triangle,
};
pub use light_tree::LightTree;
pub use memory::Footprint;
pub use prepare::{PrepareError, prepare};
pub use record::aim::Aim;
pub use record::camera::Camera;
pub use record::lens::Lens;
pub use record::light::Light;
pub use record::light_node::LightNode;
pub use record::material::{Material, MaterialKind, OPAQUE_SIGMA};
pub use record::shape::Shape;
pub use record::surroundings_row::SurroundingsRow;
pub use surroundings::Surroundings;

/// The records as the kernels read them.
pub mod device {
    pub use super::record::aim::device::Aim;
    pub use super::record::camera::device::Camera;
    pub use super::record::lens::device::Lens;
    pub use super::record::light::device::Light;
    pub use super::record::light_node::device::LightNode;
    pub use super::record::material::device::Material;
    pub use super::record::shape::device::Shape;
    pub use super::record::surroundings::device::Surroundings;
    pub use super::record::surroundings_row::device::SurroundingsRow;
    pub use crate::shape::device::{Coincidence, Cuboid, Cylinder, Sphere};
}

/// A scene ready to be rendered.
#[derive(Clone, Debug)]
pub struct Prepared {
    pub space: Space,
    pub camera: Camera,
    /// `None` for a pinhole.
    pub lens: Option<Lens>,
    /// Opaque shapes first, then file order: at equal distance the lower index is hit.
    pub shapes: Vec<Shape>,
    pub primitives: Primitives,
    pub materials: Vec<Material>,
    pub lights: Vec<Light>,
    /// Choice of a light: light i is chosen where `light_cdf[i]` ≤ u24 < `light_cdf[i + 1]`, u24 an integer below 2²⁴.
    /// So its probability, (`light_cdf[i + 1]` − `light_cdf[i]`)·2⁻²⁴, is exact in f32.
    pub light_cdf: Vec<u32>,
    /// Choice of a light by its contribution.
    pub light_tree: LightTree,
    /// For each light, the material of the shape that contains its centre, or [`NONE`].
    pub light_media: Vec<u32>,
    /// Choice of a triangle within each mesh light, in the same form; see [`Light::cdf`].
    pub triangle_cdf: Vec<u32>,
    /// The targets of light paths in bidirectional path tracing.
    pub aims: Vec<Aim>,
    /// The smallest share of all directions that a light fills, as seen from the targets of light paths.
    pub light_share: Option<f64>,
    /// Mean radiance of everything outside.
    pub background: DVec3,
    /// The picture of everything outside, if any.
    pub surroundings: Option<Surroundings>,
    /// The scene file's line, 0 if there is none.
    pub background_line: usize,
    /// The material of the shape that contains the eye, or [`NONE`].
    pub eye_medium: u32,
    /// Warnings for the user, each once.
    pub warnings: Vec<String>,
}

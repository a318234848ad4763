//! What both renderers must share, computed once and in f64: σ, eta, world-space vertices, shape frames,
//! light tables, the eye's medium.
//!
//! Positions and lengths are in rendering space ([`Space`]): the scene moved so that the middle of its bounds is the
//! origin, and scaled to about 1, which keeps f32 accurate whatever the scene's place and scale.

mod bounds;
pub mod cdf;
mod contact;
mod eye;
mod geometry;
mod lights;
pub mod material;
mod medium;
mod prepare;
mod range;
mod space;

use glam::DVec3;

pub use bounds::Bounds;

pub use crate::scene::WordLines;
use crate::settings::{Distribution, Fresnel};
pub use prepare::{PrepareError, prepare};
pub use space::Space;

/// "none" for indices of materials, lights and media.
pub const NONE: u32 = u32::MAX;

/// A scene ready to be rendered.
#[derive(Clone, Debug)]
pub struct Prepared {
    pub width: u32,
    pub height: u32,
    pub space: Space,
    pub camera: Camera,
    /// Opaque shapes first, then file order: at equal distance the lower index is hit.
    pub shapes: Vec<Shape>,
    pub spheres: Vec<Sphere>,
    pub boxes: Vec<Cuboid>,
    pub cylinders: Vec<Cylinder>,
    /// All triangles of all meshes, in the order of their shapes.
    pub triangles: Vec<Triangle>,
    /// Shading normals of each triangle's corners; empty where no mesh gives any, zero for triangles without.
    pub normals: Vec<[DVec3; 3]>,
    pub materials: Vec<Material>,
    pub lights: Vec<Light>,
    /// Choice of a light: light i is chosen where `light_cdf[i]` ≤ u24 < `light_cdf[i + 1]`, u24 an
    /// integer below 2²⁴. So its probability, (`light_cdf[i + 1]` − `light_cdf[i]`)·2⁻²⁴, is exact in f32.
    pub light_cdf: Vec<u32>,
    /// Choice of a triangle within each mesh light, in the same form; see [`Light::first`].
    pub triangle_cdf: Vec<u32>,
    /// Radiance of everything outside.
    pub background: DVec3,
    /// The scene file's line, 0 where none says so.
    pub background_line: usize,
    /// Material whose inside the eye stands in, or [`NONE`].
    pub eye_medium: u32,
    /// What the user should know, each once.
    pub warnings: Vec<String>,
}

/// Direction of the point (x, y) of the picture plane, x and y in [−1, 1]: `forward` + x·`right` + y·`up`.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    pub eye: DVec3,
    /// Length rx = ry·W/H.
    pub right: DVec3,
    /// Length ry.
    pub up: DVec3,
    /// Unit length.
    pub forward: DVec3,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum ShapeKind {
    Sphere = 0,
    Box = 1,
    Cylinder = 2,
    Mesh = 3,
}

impl ShapeKind {
    pub const EVERY: [Self; 4] = [Self::Sphere, Self::Box, Self::Cylinder, Self::Mesh];
}

#[derive(Clone, Copy, Debug)]
pub struct Shape {
    pub kind: ShapeKind,
    /// First primitive, an index into the array of its kind.
    pub first: u32,
    /// Number of primitives: 1, or the triangles of a mesh.
    pub count: u32,
    pub material: u32,
    /// Index of its light, or [`NONE`].
    pub light: u32,
    /// The scene file's line.
    pub line: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    pub centre: DVec3,
    pub radius: f64,
    pub shape: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct Cuboid {
    pub lo: DVec3,
    pub hi: DVec3,
    pub shape: u32,
}

/// The solid { base + x u + y v + z w : x² + y² ≤ radius², 0 ≤ z ≤ height }, (u, v, w) orthonormal.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    pub base: DVec3,
    pub u: DVec3,
    pub v: DVec3,
    pub w: DVec3,
    pub height: f64,
    pub radius: f64,
    pub shape: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    pub v: [DVec3; 3],
    pub shape: u32,
}

/// What a surface does with light; one file of `bsdf/` each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum MaterialKind {
    /// Emits or absorbs; ends every path.
    Black = 0,
    /// Kd only.
    Diffuse = 1,
    /// Opaque: rough reflection, Kd possible.
    Opaque = 2,
    /// Opaque: perfect mirror, Kd possible.
    Mirror = 3,
    /// Rough reflection and rough transmission, Kd possible.
    Dielectric = 4,
    /// Smooth reflection and smooth transmission, Kd possible.
    Glass = 5,
    /// Rough reflection, transmission that keeps one direction: α·|n − 1| < 1e-5. Kd possible.
    Weak = 6,
    /// |ior − 1| < 1e-7: the surface is not there.
    Nothing = 7,
}

impl MaterialKind {
    pub const EVERY: [Self; 8] = [
        Self::Black,
        Self::Diffuse,
        Self::Opaque,
        Self::Mirror,
        Self::Dielectric,
        Self::Glass,
        Self::Weak,
        Self::Nothing,
    ];
}

/// A material, with all that depends on it alone. Pairs hold the outer side first.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    pub kind: MaterialKind,
    pub distribution: Distribution,
    pub fresnel: Fresnel,
    pub kd: DVec3,
    /// Mean of Kd over RGB.
    pub kd_mean: f64,
    /// Reflectance at normal incidence for Schlick: Ks.
    pub f0: DVec3,
    /// Parameter of the distribution: width, or Phong's exponent.
    pub alpha: f64,
    /// Width: for Phong √(2/(α_p + 2)).
    pub width: f64,
    /// −ln Kt per unit length of rendering space; [`OPAQUE_SIGMA`] where Kt = 0 in a channel.
    pub sigma: DVec3,
    /// Emitted radiance.
    pub radiance: DVec3,
    /// n_o / n_i for `wo` outside, inside.
    pub eta: [f64; 2],
    /// 1 − eta², for `wo` outside, inside.
    pub one_minus_eta2: [f64; 2],
    /// (n_i / n_o)² − 1 = (1 − eta²) / eta², for `wo` outside, inside.
    pub d: [f64; 2],
    /// Probability of the diffuse lobe by norms: ‖Kd‖ / (‖Kd‖ + ‖Ks‖ + ‖Kt‖).
    pub p_d: f64,
    /// Probability of reflection once the micro-normal is drawn, by norms: ‖Ks‖ / (‖Ks‖ + ‖Kt‖).
    pub p_r: f64,
    /// The scene file's line, 0 for the default material.
    pub line: usize,
    /// Those whose words it goes by.
    pub words: WordLines,
}

/// σ of a channel with Kt = 0: finite, so that no product is NaN, and black after 1e-28 units. No σ is larger.
pub const OPAQUE_SIGMA: f64 = 1e30;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum LightKind {
    Sphere = 0,
    Box = 1,
    Cylinder = 2,
    Mesh = 3,
    Background = 4,
}

impl LightKind {
    pub const EVERY: [Self; 5] = [
        Self::Sphere,
        Self::Box,
        Self::Cylinder,
        Self::Mesh,
        Self::Background,
    ];
}

/// An emitter that is sampled explicitly.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    pub kind: LightKind,
    /// Its shape, or [`NONE`] for the background.
    pub shape: u32,
    /// Its first primitive, an index into the array of its kind. A mesh of n triangles has n + 1 entries
    /// of `triangle_cdf` from `cdf`: triangle `first + i` is chosen where cdf[i] ≤ u24 < cdf[i + 1].
    pub first: u32,
    pub count: u32,
    pub cdf: u32,
    pub radiance: DVec3,
}

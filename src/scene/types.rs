//! A scene as in its file: the file's names and units, in f64.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::film::Film;
use crate::settings::{Distribution, Fresnel};

/// A scene file, read and checked.
#[derive(Clone, Debug)]
pub struct Scene {
    pub path: PathBuf,
    pub screen: Screen,
    pub camera: Camera,
    /// The line of `camera`.
    pub camera_line: usize,
    /// `None`: a pinhole camera.
    pub lens: Option<Lens>,
    /// Radiance of everything outside; black if there are `surroundings`.
    pub background: DVec3,
    /// A picture of everything outside.
    pub surroundings: Option<Surroundings>,
    /// The line of the background, 0 if there is none.
    pub background_line: usize,
    pub materials: Vec<Material>,
    /// In file order.
    pub shapes: Vec<Shape>,
}

/// A picture of everything outside, in equal steps of both angles: its upper edge is seen along +Z of its frame, its
/// middle along +X, and +Y lies a quarter of its width to the left.
#[derive(Clone, Debug)]
pub struct Surroundings {
    pub path: PathBuf,
    /// Radiances, none negative.
    pub picture: Arc<Film>,
    /// A factor on the radiances.
    pub scale: f64,
    /// The frame in the world.
    pub rotate: DQuat,
}

/// Picture size in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    pub width: u32,
    pub height: u32,
}

/// Looks down −Z of its rotated frame, X right, Y up; a pinhole if there is no [`Lens`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub eye: DVec3,
    /// tan of half the vertical field of view.
    pub ry: f64,
    pub orientation: DQuat,
}

/// A thin lens around the eye: a disc in the plane through the eye normal to the direction of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// The line of `lens`.
    pub line: usize,
    /// Radius of the aperture; 0 is a pinhole.
    pub radius: f64,
    /// Distance of the plane in focus, along the direction of view.
    pub focus: f64,
}

/// A material and the line that introduced it (from 1; 0: the default material).
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub line: usize,
    pub words: WordLines,
    pub kind: MaterialKind,
}

/// The lines of the words that apply to a material, 0 where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WordLines {
    pub distribution: usize,
    pub fresnel: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub enum MaterialKind {
    Brdf(Brdf),
    /// Emits this radiance from both sides of its surface and reflects nothing.
    Light(DVec3),
}

/// The hand-out's material. It is opaque if Kt = 0, at any ior.
#[derive(Clone, Debug, PartialEq)]
pub struct Brdf {
    pub kd: DVec3,
    pub ks: DVec3,
    /// > 1: a Phong exponent; ≤ 1: a Beckmann or GGX width.
    pub alpha: f64,
    pub kt: DVec3,
    /// The length over which the transmittance is Kt: 1 in scene files.
    pub kt_length: f64,
    pub ior: f64,
    /// `None`: `auto`, Phong for an exponent and GGX for a width.
    pub distribution: Option<Distribution>,
    /// `None`: the scene does not set it.
    pub fresnel: Option<Fresnel>,
}

/// A closed solid, or a mesh.
#[derive(Clone, Debug)]
pub struct Shape {
    pub line: usize,
    /// Index into [`Scene::materials`].
    pub material: usize,
    pub geometry: Geometry,
}

#[derive(Clone, Debug)]
pub enum Geometry {
    Sphere {
        centre: DVec3,
        radius: f64,
    },
    /// One corner and the diagonal from it; components may be negative.
    Box {
        corner: DVec3,
        diagonal: DVec3,
    },
    /// Centre of the base, axis whose length is the height, radius; with both caps.
    Cylinder {
        base: DVec3,
        axis: DVec3,
        radius: f64,
    },
    Mesh(Mesh),
}

/// The file's triangles; p' = translate + scale · rotate · p.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub path: PathBuf,
    /// Further files that it was read from.
    pub files: Vec<PathBuf>,
    pub positions: Vec<DVec3>,
    /// One per vertex, only if the file gives them: unit length, or zero where the file's normal has no direction.
    pub normals: Option<Vec<DVec3>>,
    pub triangles: Vec<[u32; 3]>,
    pub translate: DVec3,
    pub scale: f64,
    pub rotate: DQuat,
}

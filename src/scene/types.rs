//! A scene as its file has it: names and units of the file, in f64.

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
    /// The line that says so.
    pub camera_line: usize,
    /// `None`: the camera is a pinhole.
    pub lens: Option<Lens>,
    /// Radiance of everything outside; black beside surroundings.
    pub background: DVec3,
    /// A picture of it.
    pub surroundings: Option<Surroundings>,
    /// The line that says so, 0 where none does.
    pub background_line: usize,
    pub materials: Vec<Material>,
    /// In file order.
    pub shapes: Vec<Shape>,
}

/// Everything outside as a picture shows it, in equal steps of both angles: its upper edge is seen along the +Z of its frame,
/// its middle along +X, and +Y a quarter of its width to the left.
#[derive(Clone, Debug)]
pub struct Surroundings {
    pub path: PathBuf,
    /// Radiances, none negative.
    pub picture: Arc<Film>,
    /// They are multiplied by it.
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

/// Looks down −Z of its rotated frame, X right, Y up; a pinhole, if there is no [`Lens`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub eye: DVec3,
    /// tan of half the vertical field of view.
    pub ry: f64,
    pub orientation: DQuat,
}

/// A thin lens about the eye: a disc in the plane through it that is normal to the direction of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// The line that says so.
    pub line: usize,
    /// Of its aperture; 0 is a pinhole.
    pub radius: f64,
    /// Of the plane that is sharp, along the direction of view.
    pub focus: f64,
}

/// A material and the line that brought it in (from 1; 0: the default material).
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub line: usize,
    pub words: WordLines,
    pub kind: MaterialKind,
}

/// The lines whose words a material goes by, 0 where there is none.
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

/// The hand-out's material. Kt = 0 is opaque whatever the ior says.
#[derive(Clone, Debug, PartialEq)]
pub struct Brdf {
    pub kd: DVec3,
    pub ks: DVec3,
    /// > 1: a Phong exponent; ≤ 1: a Beckmann or GGX width.
    pub alpha: f64,
    pub kt: DVec3,
    /// Kt is what this length lets through: 1 in scene files.
    pub kt_length: f64,
    pub ior: f64,
    /// `None`: `auto`, Phong for an exponent and GGX for a width.
    pub distribution: Option<Distribution>,
    /// `None`: no word in the scene.
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
    /// A corner and the diagonal from it; components may be negative.
    Box {
        corner: DVec3,
        diagonal: DVec3,
    },
    /// Base centre, axis whose length is the height, radius; with both caps.
    Cylinder {
        base: DVec3,
        axis: DVec3,
        radius: f64,
    },
    Mesh(Mesh),
}

/// Triangles as the file has them; p' = translate + scale · rotate · p.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub path: PathBuf,
    /// Files that it was read from besides its own.
    pub files: Vec<PathBuf>,
    pub positions: Vec<DVec3>,
    /// One a vertex, only where the file gives them: unit length, or zero where the file's has no direction.
    pub normals: Option<Vec<DVec3>>,
    pub triangles: Vec<[u32; 3]>,
    pub translate: DVec3,
    pub scale: f64,
    pub rotate: DQuat,
}

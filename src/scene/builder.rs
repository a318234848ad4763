//! The scene under construction: the state set by the lines read so far.

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::log::Log;
use super::surroundings::Outside;
use super::text::Token;
use super::{
    Brdf, Camera, Errors, Geometry, Lens, Material, MaterialKind, Read, Scene, Screen, Shape,
    WordLines,
};
use crate::settings::{Distribution, Fresnel};

/// A command that counts only once: unseen, seen but malformed, or set.
#[derive(Clone, Debug)]
pub(super) enum Once<T> {
    Unseen,
    Wrong,
    Set(T),
}

impl<T> Once<T> {
    /// Sets the value of `command`, `None` if it could not be read. Warns if the command was seen before.
    pub fn set(&mut self, value: Option<T>, command: Token<'_>, log: &mut Log) {
        if !self.is_unseen() {
            let message = format!("`{}` is given more than once", command.text);
            log.warning(command.place, message, "the last one is used");
        }
        *self = value.map_or(Once::Wrong, Once::Set);
    }

    fn is_unseen(&self) -> bool {
        matches!(self, Once::Unseen)
    }
}

/// The scene and the diagnostics so far.
pub(super) struct Builder {
    pub log: Log,
    path: PathBuf,
    pub screen: Once<Screen>,
    /// With its line number.
    pub camera: Once<(Camera, usize)>,
    pub lens: Once<Lens>,
    /// With its line number.
    pub background: Once<(Outside, usize)>,
    /// For materials that follow.
    pub distribution: Option<Distribution>,
    /// For materials that follow.
    pub fresnel: Option<Fresnel>,
    /// Lines of the words `distribution` and `fresnel`.
    pub words: WordLines,
    /// For shapes that follow.
    material: Material,
    /// Index of `material`, once a shape uses it.
    taken: Option<usize>,
    materials: Vec<Material>,
    shapes: Vec<Shape>,
    /// Spheres that follow may carry surroundings.
    expects_carrier: bool,
    /// Indices of those spheres. Each carries surroundings if it contains the eye.
    carriers: Vec<usize>,
}

impl Builder {
    /// An empty scene.
    pub fn new(path: &Path, log: Log) -> Self {
        Self {
            log,
            path: path.to_owned(),
            screen: Once::Unseen,
            camera: Once::Unseen,
            lens: Once::Unseen,
            background: Once::Unseen,
            distribution: None,
            fresnel: None,
            words: WordLines::default(),
            material: default_material(),
            taken: None,
            materials: Vec::new(),
            shapes: Vec::new(),
            expects_carrier: false,
            carriers: Vec::new(),
        }
    }

    /// The folder of the scene file; empty for the working directory.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// The material of the shapes that follow.
    pub fn set_material(&mut self, line: usize, kind: MaterialKind) {
        self.material = Material {
            line,
            words: self.words,
            kind,
        };
        self.taken = None;
        self.expects_carrier = false;
    }

    /// Until the next material, a sphere around the eye carries surroundings and is no shape.
    pub fn expect_carrier(&mut self) {
        self.expects_carrier = true;
    }

    /// Adds a shape with the current material. Materials that no shape uses are dropped.
    pub fn add_shape(&mut self, line: usize, geometry: Geometry) {
        let material = *self.taken.get_or_insert_with(|| {
            self.materials.push(self.material.clone());
            self.materials.len() - 1
        });
        if self.expects_carrier && matches!(geometry, Geometry::Sphere { .. }) {
            self.carriers.push(self.shapes.len());
        }
        self.shapes.push(Shape {
            line,
            material,
            geometry,
        });
    }

    /// The scene, if there are no errors; with `strict`, warnings count as errors.
    pub fn finish(mut self, text: String, strict: bool) -> Result<Read, Errors> {
        self.required(self.screen.is_unseen(), "screen W H");
        self.required(self.camera.is_unseen(), "camera ex ey ez  ry  ORIENTATION");
        if let Once::Set((camera, _)) = self.camera {
            self.take_carriers(camera.eye);
        }
        let (background, surroundings, background_line) = match self.background {
            Once::Set((Outside::Constant(radiance), line)) => (radiance, None, line),
            Once::Set((Outside::Picture(picture), line)) => (DVec3::ZERO, Some(picture), line),
            Once::Unseen | Once::Wrong => (DVec3::ZERO, None, 0),
        };
        let lens = match self.lens {
            Once::Set(lens) => Some(lens),
            Once::Unseen | Once::Wrong => None,
        };
        let scene = match (self.screen, self.camera) {
            (Once::Set(screen), Once::Set((camera, camera_line))) => Some(Scene {
                path: self.path,
                screen,
                camera,
                camera_line,
                lens,
                background,
                surroundings,
                background_line,
                materials: self.materials,
                shapes: self.shapes,
            }),
            _ => None,
        };
        let (scene, warnings) = self.log.finish(scene, strict)?;
        Ok(Read {
            scene,
            warnings,
            text,
            is_listing: false,
        })
    }

    /// Removes the spheres around `eye` that carry surroundings.
    fn take_carriers(&mut self, eye: DVec3) {
        let contains_eye = |shape: &Shape| matches!(shape.geometry, Geometry::Sphere { centre, radius } if eye.distance(centre) < radius);
        for index in std::mem::take(&mut self.carriers).into_iter().rev() {
            if contains_eye(&self.shapes[index]) {
                self.shapes.remove(index);
            }
        }
    }

    /// Reports an error if the command that `usage` begins with is missing.
    fn required(&mut self, missing: bool, usage: &str) {
        if missing {
            let word = usage.split(' ').next().unwrap_or(usage);
            let message = format!("{} has no `{word}`", self.log.name());
            self.log
                .file_error(message)
                .help(format!("add a line: {usage}"));
        }
    }
}

/// The course framework's material for shapes that no material precedes.
fn default_material() -> Material {
    let brdf = Brdf {
        kd: DVec3::new(1.0, 0.5, 0.0),
        ks: DVec3::ONE,
        alpha: 1.0,
        kt: DVec3::ZERO,
        kt_length: 1.0,
        ior: 1.0,
        distribution: None,
        fresnel: None,
    };
    Material {
        line: 0,
        words: WordLines::default(),
        kind: MaterialKind::Brdf(brdf),
    }
}

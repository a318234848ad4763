//! The scene under way: what the lines read so far have set.

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

/// A command that counts once: unseen, seen on a line but wrong, or set there.
#[derive(Clone, Debug)]
pub(super) enum Once<T> {
    Unseen,
    Wrong,
    Set(T),
}

impl<T> Once<T> {
    /// Takes what `command` says, which could not be read where it is `None`; warns if it is not the first.
    pub fn set(&mut self, value: Option<T>, command: Token<'_>, log: &mut Log) {
        if !self.is_unseen() {
            let message = format!("`{}` stands here once more", command.text);
            log.warning(command.place, message, "the last one counts");
        }
        *self = value.map_or(Once::Wrong, Once::Set);
    }

    fn is_unseen(&self) -> bool {
        matches!(self, Once::Unseen)
    }
}

/// What has been read, and what is wrong with it.
pub(super) struct Builder {
    pub log: Log,
    path: PathBuf,
    pub screen: Once<Screen>,
    /// With its line.
    pub camera: Once<(Camera, usize)>,
    pub lens: Once<Lens>,
    /// With its line.
    pub background: Once<(Outside, usize)>,
    /// For the materials that follow.
    pub distribution: Option<Distribution>,
    /// For the materials that follow.
    pub fresnel: Option<Fresnel>,
    /// Of these two words.
    pub words: WordLines,
    /// For the shapes that follow.
    material: Material,
    /// The index of `material`, once a shape has taken it.
    taken: Option<usize>,
    materials: Vec<Material>,
    shapes: Vec<Shape>,
    /// The shapes that follow may carry surroundings.
    expects_carrier: bool,
    /// Spheres that do if the eye is in them: indices of shapes.
    carriers: Vec<usize>,
}

impl Builder {
    /// Nothing read yet.
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

    /// Until the next material a sphere about the eye carries surroundings, and is no shape.
    pub fn expect_carrier(&mut self) {
        self.expects_carrier = true;
    }

    /// Adds a shape of the current material. Materials that no shape takes are not kept.
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

    /// The scene, if nothing is wrong; with `strict` a warning is.
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

    /// Takes away the spheres that carry surroundings about `eye`.
    fn take_carriers(&mut self, eye: DVec3) {
        let holds_eye = |shape: &Shape| matches!(shape.geometry, Geometry::Sphere { centre, radius } if eye.distance(centre) < radius);
        for index in std::mem::take(&mut self.carriers).into_iter().rev() {
            if holds_eye(&self.shapes[index]) {
                self.shapes.remove(index);
            }
        }
    }

    /// An error if the command that `usage` begins with is not there.
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

/// What the course's framework gives a shape that no material precedes.
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

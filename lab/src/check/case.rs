//! One case: a scene, how it is rendered, what is stiff about it, and its bounds.

use std::path::Path;
use std::sync::Arc;

use glam::DQuat;

use super::bound;
use vkpt::film::Film;
use vkpt::scene::{self, Errors, Geometry, Mesh, Scene, Surroundings};
use vkpt::settings::Settings;

/// A small picture at a limit of f32.
pub struct Case {
    /// Group, a slash, the place on its axis: `alpha/ggx/1e-3`.
    pub name: String,
    /// A description, in one line: what is stiff about it.
    pub about: String,
    /// The scene file; [`Case::mesh`] follows it, in its last material.
    pub text: String,
    pub mesh: Option<Mesh>,
    /// The surroundings, in place of the file's background.
    pub surroundings: Option<Film>,
    pub settings: Settings,
    /// Left, top, right, bottom, as of a rendering.
    pub crop: Option<[u32; 4]>,
    pub spp: u32,
    /// Skipped in a quick run: it takes seconds.
    pub slow: bool,
    pub stiffness: Stiffness,
    /// The largest contribution allowed for one path, with the reason.
    pub weight: Option<(f64, String)>,
    pub expectations: Vec<Expectation>,
}

/// The numbers that bound the difference to f64.
pub struct Stiffness {
    /// Vertices that suffice for 99 % of the paths.
    pub vertices: f64,
    /// The growth of an error before it affects a decision.
    pub decisions: f64,
    /// Its growth before it affects the path's contribution.
    pub light: f64,
    /// Why these numbers.
    pub why: String,
}

/// Knowledge of the picture without rendering it.
pub enum Expectation {
    /// Mean radiance over pixels and channels, by a closed form or by quadrature.
    Mean { value: f64, by: String },
    /// The same, no more than `value`.
    AtMost { value: f64, by: String },
    /// The same mean as another case's.
    SameMean { case: String, why: String },
    /// The same radiance as another case's in every sample, to the bit.
    SameBits { case: String, why: String },
    /// A warning about the scene that contains these words: the response to scenes beyond f32, or beyond the model.
    Warning(String),
}

impl Case {
    /// A case whose paths are `stiff`, with 16 samples per pixel, the default settings and no expectations.
    pub fn new(
        name: impl Into<String>,
        about: impl Into<String>,
        text: impl Into<String>,
        stiff: Stiffness,
    ) -> Self {
        Self {
            name: name.into(),
            about: about.into(),
            text: text.into(),
            mesh: None,
            surroundings: None,
            settings: Settings::default(),
            crop: None,
            spp: 16,
            slow: false,
            stiffness: stiff,
            weight: None,
            expectations: Vec::new(),
        }
    }

    pub fn mesh(mut self, mesh: Mesh) -> Self {
        self.mesh = Some(mesh);
        self
    }

    pub fn surroundings(mut self, picture: Film) -> Self {
        self.surroundings = Some(picture);
        self
    }

    pub fn settings(mut self, settings: Settings) -> Self {
        self.settings = settings;
        self
    }

    pub fn spp(mut self, spp: u32) -> Self {
        self.spp = spp;
        self
    }

    pub fn crop(mut self, crop: [u32; 4]) -> Self {
        self.crop = Some(crop);
        self
    }

    pub fn slow(mut self) -> Self {
        self.slow = true;
        self
    }

    pub fn weight(mut self, most: f64, why: impl Into<String>) -> Self {
        self.weight = Some((most, why.into()));
        self
    }

    /// The mean over pixels and channels is `value`.
    pub fn mean(self, value: f64, by: impl Into<String>) -> Self {
        self.expect(Expectation::Mean {
            value,
            by: by.into(),
        })
    }

    /// That mean is at most `value`.
    pub fn at_most(self, value: f64, by: impl Into<String>) -> Self {
        self.expect(Expectation::AtMost {
            value,
            by: by.into(),
        })
    }

    pub fn expect(mut self, expectation: Expectation) -> Self {
        self.expectations.push(expectation);
        self
    }

    /// The part of the name before the first slash.
    pub fn group(&self) -> &str {
        self.name.split('/').next().unwrap_or_default()
    }

    /// The scene, and its warnings.
    ///
    /// # Errors
    /// As reading a scene file.
    pub fn scene(&self) -> Result<(Scene, Vec<String>), Errors> {
        // A shape that the mesh replaces: it has the material and a line.
        let place = if self.mesh.is_some() {
            "sphere 0 0 0 1\n"
        } else {
            ""
        };
        let text = format!("{}{place}", self.text);
        let read = scene::parse(&text, Path::new(&self.name), false)?;
        let warnings = read.warnings.iter().map(ToString::to_string).collect();
        let mut scene = read.scene;
        if let (Some(mesh), Some(shape)) = (&self.mesh, scene.shapes.last_mut()) {
            shape.geometry = Geometry::Mesh(mesh.clone());
        }
        scene.surroundings = self.surroundings.as_ref().map(|picture| Surroundings {
            path: self.name.clone().into(),
            picture: Arc::new(picture.clone()),
            scale: 1.0,
            rotate: DQuat::IDENTITY,
        });
        Ok((scene, warnings))
    }
}

impl Stiffness {
    pub fn new(vertices: f64, decisions: f64, light: f64, why: impl Into<String>) -> Self {
        Self {
            vertices,
            decisions,
            light,
            why: why.into(),
        }
    }

    /// The largest probability of a path to diverge from f64's.
    pub fn diverged(&self) -> f64 {
        bound::diverged(self.vertices, self.decisions)
    }

    /// The largest relative difference of 99 % of those that do not diverge.
    pub fn close(&self) -> f64 {
        bound::carried(self.vertices, self.light)
    }
}

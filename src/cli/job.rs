//! From a command line to a scene that is ready to be rendered.

use std::path::Path;
use std::time::Instant;

use super::exit::{Failure, point_out, warn};
use crate::prepared::{self, Prepared};
use crate::render::{Job, KernelChoice, Until};
use crate::scene;
use crate::settings::Settings;

/// What a command line asks to be rendered.
pub struct Request<'a> {
    pub scene: &'a Path,
    pub settings: Settings,
    pub size: Option<[u32; 2]>,
    pub crop: Option<[u32; 4]>,
    pub spp: u32,
    pub seed: u32,
    pub strict: bool,
}

/// A scene read, checked and prepared, its warnings told.
pub struct Ready {
    pub prepared: Prepared,
    pub settings: Settings,
    pub warnings: Vec<String>,
    pub read_s: f64,
    pub prepare_s: f64,
}

impl Ready {
    /// Reads and prepares the scene that the command line names.
    pub fn new(request: &Request) -> Result<Self, Failure> {
        Self::with_text(request).map(|(ready, _)| ready)
    }

    /// The same, with the text of the scene file.
    pub fn with_text(request: &Request) -> Result<(Self, String), Failure> {
        let settings = request.settings;
        let start = Instant::now();
        let read = scene::read(request.scene, request.strict).map_err(Failure::Scene)?;
        let read_s = start.elapsed().as_secs_f64();
        let mut warnings: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
        point_out(read.warnings);
        let start = Instant::now();
        let prepared =
            prepared::prepare(&read.scene, &settings, request.size).map_err(Failure::Prepare)?;
        let prepare_s = start.elapsed().as_secs_f64();
        if request.strict && !prepared.warnings.is_empty() {
            return Err(Failure::Strict(prepared.warnings));
        }
        prepared.warnings.iter().for_each(|warning| warn(warning));
        warnings.extend(prepared.warnings.iter().cloned());
        let ready = Self {
            prepared,
            settings,
            warnings,
            read_s,
            prepare_s,
        };
        Ok((ready, read.text))
    }

    /// The job that the command line describes.
    pub fn job(&self, request: &Request) -> Result<Job<'_>, Failure> {
        let Prepared { width, height, .. } = self.prepared;
        if let Some([_, _, x1, y1]) = request
            .crop
            .filter(|crop| crop[2] > width || crop[3] > height)
        {
            return Err(Failure::Usage(format!(
                "--crop ends at {x1},{y1}, outside the picture of {width}x{height} pixels"
            )));
        }
        Ok(Job {
            prepared: &self.prepared,
            settings: self.settings,
            spp: request.spp,
            until: Until::default(),
            seed: request.seed,
            crop: request.crop,
            aovs: &[],
            kernel: KernelChoice::Composed,
        })
    }
}

//! From a command line to a scene ready to render.

use std::time::Instant;

use miette::Severity;

use super::exit::{Failure, note, point_out, warn};
use super::integrator;
use super::source::Source;
use super::{listing, memory};
use vkpt::prepared::{self, Camera, Prepared};
use vkpt::render::{Job, KernelChoice, Until};
use vkpt::scene::{Diagnostic, Scene};
use vkpt::settings::Settings;

/// The rendering that a command line requests.
pub struct Request<'a> {
    pub scene: &'a Source,
    pub settings: Settings,
    /// Whether the scene chooses its integrator.
    pub auto: bool,
    /// The name of a glTF file's camera.
    pub camera: Option<&'a str>,
    pub size: Option<[u32; 2]>,
    pub crop: Option<[u32; 4]>,
    pub spp: u32,
    pub seed: u32,
    pub strict: bool,
    /// Only warnings and errors are printed.
    pub quiet: bool,
}

/// A scene that was read, its warnings printed.
pub struct Loaded {
    pub scene: Scene,
    /// The text that was read, line by line.
    pub text: String,
    /// Whether its lines are made up: the file itself has none.
    is_listing: bool,
    warnings: Vec<String>,
    read_s: f64,
}

/// A prepared scene, its warnings printed.
pub struct Ready {
    pub prepared: Prepared,
    pub settings: Settings,
    /// Why the integrator was chosen, if the scene chose it.
    pub why: Option<&'static str>,
    /// Includes those of reading it.
    pub warnings: Vec<String>,
    /// The lines that messages refer to, if the file itself has no lines.
    pub listing: Option<String>,
    pub read_s: f64,
    pub prepare_s: f64,
}

impl Loaded {
    /// Reads the scene that the command line names.
    pub fn new(request: &Request) -> Result<Self, Failure> {
        let start = Instant::now();
        let read = request.scene.read(request.strict, request.camera);
        let mut read = read.map_err(Failure::Scene)?;
        let read_s = start.elapsed().as_secs_f64();
        let is_warning = |d: &Diagnostic| d.severity == Severity::Warning;
        let warnings = read.warnings.iter().filter(|d| is_warning(d));
        let warnings = warnings.map(ToString::to_string).collect();
        // A quiet run omits notes.
        read.warnings.retain(|d| is_warning(d) || !request.quiet);
        point_out(read.warnings);
        Ok(Self {
            scene: read.scene,
            text: read.text,
            is_listing: read.is_listing,
            warnings,
            read_s,
        })
    }

    /// The scene by the settings of the request.
    pub fn prepare(&self, request: &Request) -> Result<Ready, Failure> {
        integrator::check(&request.settings)?;
        memory::announce(&self.scene, request.quiet)?;
        let start = Instant::now();
        let prepared = self.prepare_in_silence(request).inspect_err(|failure| {
            if let Failure::Prepare(_, error) = failure {
                self.print_lines(&[error.to_string()]);
            }
        })?;
        let prepare_s = start.elapsed().as_secs_f64();
        let settled = (request.auto).then(|| integrator::settled(&prepared, request.settings));
        let settings = settled.as_ref().map_or(request.settings, |s| s.settings);
        let mut warnings = prepared.warnings.clone();
        warnings.extend(integrator::unseen(&prepared, &settings));
        self.print_lines(&warnings);
        if request.strict && !warnings.is_empty() {
            let name = request.scene.name();
            let named = warnings.iter().map(|warning| format!("{name}: {warning}"));
            return Err(Failure::Strict(named.collect()));
        }
        warnings.iter().for_each(|warning| warn(warning));
        Ok(Ready {
            settings,
            why: settled.map(|s| s.why),
            warnings: [&self.warnings[..], &warnings].concat(),
            listing: self.is_listing.then(|| self.text.clone()),
            read_s: self.read_s,
            prepare_s,
            prepared,
        })
    }

    /// Prints the lines that messages name, if the file itself does not have them.
    fn print_lines(&self, messages: &[String]) {
        if self.is_listing {
            let lines = listing::named(&self.text, &messages.join("\n"));
            lines.iter().for_each(|line| note(line));
        }
    }

    /// The place of a line of the scene in messages about the file `name`.
    pub fn place(&self, name: &str, line: usize) -> String {
        match listing::line(&self.text, line).filter(|_| self.is_listing) {
            Some(text) => format!("{name}, `{text}`"),
            None => format!("{name}:{line}"),
        }
    }

    /// The same, without printing warnings.
    pub fn prepare_in_silence(&self, request: &Request) -> Result<Prepared, Failure> {
        prepared::prepare(&self.scene, &request.settings, request.size)
            .map_err(|error| Failure::Prepare(request.scene.name(), error))
    }
}

impl Ready {
    /// Reads and prepares the scene that the command line names.
    pub fn new(request: &Request) -> Result<Self, Failure> {
        Loaded::new(request)?.prepare(request)
    }

    /// The job that the command line describes.
    pub fn job(&self, request: &Request) -> Result<Job<'_>, Failure> {
        let Camera { width, height, .. } = self.prepared.camera;
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
            classes: &[],
            kernel: KernelChoice::Composed,
        })
    }
}

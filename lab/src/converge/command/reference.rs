//! The reference: a file, or two halves that vkpt renders itself.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::arguments::ConvergeArguments;
use super::kept::{self, Kept};
use super::progress;
use crate::cli::exit::{Failure, warn};
use crate::cli::inputs::Input;
use crate::cli::integrator::{Settled, settled};
use crate::cli::progress::Display;
use crate::cli::stderr::{belongs, standard_errors};
use crate::converge::{ConvergeError, Halves, Plan, halves};
use vkpt::image::file::stderr_path;
use vkpt::image::{self, Precision};
use vkpt::metrics::convergence::{Reference, STANDARD_ERRORS};
use vkpt::render::{Engine, Job};
use vkpt::report::human::duration;
use vkpt::settings::{Model, Settings};

/// The most samples per pixel of a reference that vkpt renders itself.
const MOST: u32 = 1 << 24;

/// A reference and its name.
pub struct Named {
    pub name: String,
    pub reference: Reference,
}

/// The references of all jobs.
pub enum References {
    /// The same for all.
    Given(Named),
    /// One for each model, rendered by vkpt itself: models converge to different pictures.
    Own(Vec<(Model, Named)>),
}

impl References {
    /// The given reference, or one for each model of the jobs; `None` if ctrl-c came first.
    pub fn new(
        given: Option<Named>,
        jobs: &[Job],
        engine: &Engine,
        plan: &Plan,
        stop: &AtomicBool,
        quiet: bool,
    ) -> Result<Option<Self>, Failure> {
        if let Some(named) = given {
            return Ok(Some(Self::Given(named)));
        }
        let mut all: Vec<(Model, Named)> = Vec::new();
        for job in jobs {
            let model = job.settings.model;
            if all.iter().any(|(other, _)| *other == model) {
                continue;
            }
            let mut display = Display::new(quiet);
            let made = own(job, engine, plan, stop, &mut display)?;
            display.finish();
            let Some(named) = made else { return Ok(None) };
            all.push((model, named));
        }
        Ok(Some(Self::Own(all)))
    }

    /// The reference of one of the jobs.
    pub fn of(&self, job: &Job) -> &Named {
        match self {
            Self::Given(named) => named,
            Self::Own(all) => {
                let of = |(model, _): &&(Model, Named)| *model == job.settings.model;
                &all.iter().find(of).unwrap_or(&all[0]).1
            }
        }
    }

    pub fn is_given(&self) -> bool {
        matches!(self, Self::Given(_))
    }
}

/// The files that a reference may be read from.
pub fn inputs(arguments: &ConvergeArguments) -> Vec<Input> {
    match &arguments.reference {
        Some(path) => vec![
            Input::new("the reference", path),
            Input::new("the standard errors of the reference", &stderr_path(path)),
        ],
        None => (kept::files().iter())
            .map(|path| Input::new("a cached reference", path))
            .collect(),
    }
}

/// The picture of `--reference`, with the standard errors next to it, if present; `size` is that of the renderings.
pub fn given(arguments: &ConvergeArguments, size: [u32; 2]) -> Result<Option<Named>, Failure> {
    let path = arguments.reference.as_deref();
    path.map(|path| from_file(path, size)).transpose()
}

fn from_file(path: &Path, size: [u32; 2]) -> Result<Named, Failure> {
    let failure = |message: String| Failure::Pictures(vec![message]);
    let picture = image::read(path).map_err(|e| failure(e.to_string()))?;
    let errors = stderr_path(path);
    let stderr = errors.exists().then(|| image::read(&errors));
    let stderr = stderr.transpose().map_err(|e| failure(e.to_string()))?;
    if let Some(stderr) = &stderr {
        let advice = "remove it";
        belongs((&errors, stderr), (path, &picture), advice).map_err(failure)?;
    }
    let (film, name) = (picture.film, path.display().to_string());
    if [film.width, film.height] != size {
        return Err(failure(format!(
            "the reference {name} has {}×{} pixels, the renderings {}×{}: give both the same --size and --crop",
            film.width, film.height, size[0], size[1]
        )));
    }
    if matches!(picture.precision, Precision::Srgb { .. }) {
        warn(&format!(
            "{name} is a PNG: its rounding and clipping count as error"
        ));
    }
    let reference =
        Reference::picture(film, stderr.as_ref().map(standard_errors)).map_err(|e| {
            let is_stderr = e.picture() == Some(STANDARD_ERRORS);
            let path = if is_stderr { &*errors } else { path };
            failure(format!("{}: {e}", path.display()))
        })?;
    Ok(Named { name, reference })
}

/// Two halves by the model of `job`, rendered as long as the plan samples. They use the default estimator and the integrator
/// that the scene chooses, not the estimators that are measured: none judges itself. `None` if ctrl-c came first.
fn own(
    job: &Job,
    engine: &Engine,
    plan: &Plan,
    stop: &AtomicBool,
    display: &mut Display,
) -> Result<Option<Named>, Failure> {
    let settings = Settings {
        model: job.settings.model,
        ..Settings::default()
    };
    let Settled { settings, .. } = settled(job.prepared, settings);
    let job = Job { settings, ..*job };
    let kept = Kept::new(&job);
    if let Some(halves) = kept.read(job.size(), plan.seconds) {
        return named(halves, ", cached by an earlier run", plan).map(Some);
    }
    let effort = (plan.seconds, MOST);
    let made = halves(&job, engine, effort, stop, &mut |p| {
        progress::show(display, &p)
    });
    let Some(halves) = made? else {
        return Ok(None);
    };
    kept.write(&halves);
    named(halves, "", plan).map(Some)
}

fn named(halves: Halves, origin: &str, plan: &Plan) -> Result<Named, Failure> {
    let (spp, time) = (halves.spp, duration(halves.seconds));
    let [a, b] = halves.films;
    let reference = Reference::halves(a, b, &plan.viewing).map_err(ConvergeError::Metrics)?;
    let name = format!("two halves of {spp} spp each, {time}{origin}");
    Ok(Named { name, reference })
}

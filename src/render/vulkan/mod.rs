//! Rendering on a Vulkan device: slices of samples, until every pixel has its samples.

mod beside;
mod device_film;
mod eye_paths;
mod kernel;
mod light;
mod light_paths;
mod limits;
mod outcomes;
mod path;
mod path_film;
mod rendering;
mod replicates;
mod run;
mod scene_buffers;

use std::sync::atomic::AtomicBool;

use super::course::Course;
use super::follow::{Grows, Watch, follow};
use super::replicates::Growing;
use super::several::Ranges;
use super::{Job, Outcome, RenderError, Start, Stats};
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::layout::Record;
use crate::settings::Integrator;
pub use kernel::statistics;
use light::LightRun;
pub use limits::DispatchLimits;
pub use outcomes::Outcomes;
use path::PathRun;
use rendering::Rendering;
use replicates::Replicates;
use run::Run;

/// Why a rendering ended without a picture, and its result so far.
#[derive(Debug)]
pub struct Failed {
    pub error: RenderError,
    /// From the first slice on.
    pub so_far: Option<Box<Outcome>>,
}

impl<E: Into<RenderError>> From<E> for Failed {
    fn from(error: E) -> Self {
        Self {
            error: error.into(),
            so_far: None,
        }
    }
}

/// Renders on `device` from `start` on; ends early, with whole samples in every pixel, once `stop` is set.
pub fn render(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, Failed> {
    match job.settings.estimator.integrator {
        Integrator::Path => render_by::<PathRun>(job, device, limits, start, stop, watch),
        Integrator::Light | Integrator::Bidirectional => {
            render_by::<LightRun>(job, device, limits, start, stop, watch)
        }
    }
}

/// Renderings by several seeds on `device`.
pub fn replicates<'a>(
    job: &'a Job<'a>,
    device: &'a Device,
    limits: DispatchLimits,
    seeds: &[u32],
) -> Result<Box<dyn Growing + 'a>, RenderError> {
    Ok(match job.settings.estimator.integrator {
        Integrator::Path => Box::new(Replicates::<PathRun, _>::new(job, device, limits, seeds)?),
        Integrator::Light | Integrator::Bidirectional => {
            Box::new(Replicates::<LightRun, _>::new(job, device, limits, seeds)?)
        }
    })
}

fn render_by<'a, R: Rendering<'a>>(
    job: &'a Job<'a>,
    device: &'a Device,
    limits: DispatchLimits,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, Failed> {
    let part = start.part(job)?;
    let mut run = Run::<R>::new(job, device, limits)?;
    run.rendering.go_on(part)?;
    let mut course = Course::new(job, stop, start, limits.dispatch_time);
    let ended = follow(&mut course, &mut run, watch);
    let so_far = course.so_far(run.part(), run.stats());
    match ended {
        Ok(()) => Ok(so_far),
        Err(error) => Err(Failed {
            error,
            so_far: Some(Box::new(so_far)),
        }),
    }
}

/// Runs `work` with a maker of parts of the job's picture on `device`.
pub fn with_ranges(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    work: &mut dyn FnMut(&mut dyn Ranges) -> Result<Stats, RenderError>,
) -> Result<Stats, RenderError> {
    match job.settings.estimator.integrator {
        Integrator::Path => work(&mut Run::<PathRun>::new(job, device, limits)?),
        Integrator::Light | Integrator::Bidirectional => {
            work(&mut Run::<LightRun>::new(job, device, limits)?)
        }
    }
}

/// The events of one path: sample `index` of the pixel at column and row `pixel`.
pub fn records(
    job: &Job,
    device: &Device,
    [column, row]: [u32; 2],
    index: u32,
) -> Result<Vec<Record>, RenderError> {
    /// Some thousand bounces; the rest of a longer path is dropped.
    const CAPACITY: u32 = 8192;
    let job = Job {
        crop: Some([column, row, column + 1, row + 1]),
        ..*job
    };
    let features = job.features();
    let limits = DispatchLimits::of(device)?;
    let recording = Recording::Events(CAPACITY);
    let mut run = PathRun::recording(&job, device, &features, limits, recording)?;
    run.restart(0, index)?;
    run.advance_tile(0, 1)?;
    run.records()
}

//! Rendering on a Vulkan device: slices of samples, until every pixel has its samples.

mod develop;
mod eye_paths;
mod kernel;
mod light;
mod light_paths;
mod limits;
mod outcomes;
mod path;
mod rendering;
mod replicates;
mod scene_buffers;
mod tile_film;

use std::sync::atomic::AtomicBool;

use super::course::Course;
use super::replicates::Growing;
use super::{HostFilm, Job, Outcome, Progress, RenderError, Stats, standard_errors};
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

/// Renders on `device`; ends early, with whole samples in every pixel, once `stop` is set.
pub fn render(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    match job.settings.estimator.integrator {
        Integrator::Path => render_by::<PathRun>(job, device, limits, stop, progress),
        Integrator::Light | Integrator::Bidirectional => {
            render_by::<LightRun>(job, device, limits, stop, progress)
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
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    let features = job.features();
    let mut run = R::new(job, device, &features, limits)?;
    let compile_s = run.compile()?.as_secs_f64();

    let mut course = Course::new(job, stop);
    while let Some(samples) = course.next_slice() {
        let mut part = |part| progress(course.progress(samples, part));
        let longest = run.advance(samples, &mut part)?;
        course.reached(samples, longest, || run.film().halves(samples));
    }
    let (done, render_s) = (course.done(), course.seconds());
    let (end, errors) = course.finish();

    let (counts, costs) = (run.film().counts(), *run.costs());
    let stats = Stats {
        device: device.info().name.clone(),
        driver: device.info().driver.clone(),
        set_up: costs.set_up,
        compile_s,
        render_s,
        gpu_s: Some(costs.gpu_time.as_secs_f64()),
        samples: u64::from(done) * u64::from(job.area().pixels()),
        rays: counts.rays,
        dropped: counts.dropped,
        long_paths: counts.long_paths,
        underflows: counts.underflows,
        largest: run.film().largest(),
        features: features.names(),
        spirv_bytes: costs.spirv_bytes,
        buffers: run.buffers(),
    };
    Ok(Outcome {
        film: run.film().picture(done),
        stderr: standard_errors(job, run.film(), done),
        spp: done,
        end,
        errors,
        stats,
    })
}

/// The events of one path: sample `index` of the pixel at column and row `pixel`.
pub fn records(
    job: &Job,
    device: &Device,
    [column, row]: [u32; 2],
    index: u32,
) -> Result<Vec<Record>, RenderError> {
    /// Some thousand bounces; the rest of a longer path is left out.
    const CAPACITY: u32 = 8192;
    let job = Job {
        crop: Some([column, row, column + 1, row + 1]),
        ..*job
    };
    let features = job.features();
    let limits = DispatchLimits::of(device)?;
    let recording = Recording::Events(CAPACITY);
    let mut run = PathRun::recording(&job, device, &features, limits, recording)?;
    run.sample_begin = index;
    run.advance_tile(0, 1)?;
    run.records()
}

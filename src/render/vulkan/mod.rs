//! Rendering on a Vulkan device: tiles × slices of samples, until every pixel has its samples.

mod develop;
mod limits;
mod outcomes;
mod replicates;
mod run;
mod scene_buffers;
mod tile_film;

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use super::course::Course;
use super::{Job, Outcome, Progress, RenderError, Stats};
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::layout::Record;
use develop::Counts;
pub use limits::DispatchLimits;
pub use outcomes::Outcomes;
pub use replicates::Replicates;
use run::Run;

/// Renders on `device`; ends early, with whole samples in every pixel, once `stop` is set.
pub fn render(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    let features = job.features();
    let mut run = Run::new(job, device, &features, limits, Recording::Nothing)?;
    let compile_s = run.compile()?.as_secs_f64();
    run.gpu_time = Duration::ZERO;

    let mut course = Course::new(job, stop);
    sample(&mut run, job, &mut course, progress)?;
    let (done, render_s) = (course.done(), course.seconds());
    let (end, errors) = course.finish();

    let counts = Counts::of(&run.tiles);
    let stats = Stats {
        device: device.info().name.clone(),
        driver: device.info().driver.clone(),
        set_up: run.set_up,
        compile_s,
        render_s,
        gpu_s: Some(run.gpu_time.as_secs_f64()),
        samples: u64::from(done) * u64::from(job.area().pixels()),
        rays: counts.rays,
        dropped: counts.dropped,
        long_paths: counts.long_paths,
        underflows: counts.underflows,
        features: features.names(),
        spirv_bytes: run.spirv_bytes,
        buffers: run.buffers(),
    };
    Ok(Outcome {
        film: develop::picture(&run.tiles, job.area(), done),
        stderr: (features.keeps_moments() && done >= 2)
            .then(|| develop::standard_errors(&run.tiles, job.area(), done)),
        spp: done,
        end,
        errors,
        stats,
    })
}

/// Slices of samples over all tiles.
fn sample(
    run: &mut Run,
    job: &Job,
    course: &mut Course,
    progress: &mut dyn FnMut(Progress),
) -> Result<(), RenderError> {
    while let Some(samples) = course.next_slice() {
        let mut longest = Duration::ZERO;
        for tile in 0..run.tiles.len() {
            longest = longest.max(run.advance(tile, samples)?);
            let part = (tile + 1) as f64 / run.tiles.len() as f64;
            progress(course.progress(samples, part));
        }
        course.reached(samples, longest, || {
            develop::halves(&run.tiles, job.area(), samples)
        });
    }
    Ok(())
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
    let mut run = Run::new(&job, device, &features, limits, Recording::Events(CAPACITY))?;
    run.sample_begin = index;
    run.advance(0, 1)?;
    run.records()
}

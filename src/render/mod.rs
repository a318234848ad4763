//! Rendering: from a prepared scene and a device to a film.

mod best;
mod both;
mod classes;
mod course;
mod cpu;
mod error;
mod follow;
mod host_film;
mod job;
mod joining;
mod layers;
mod light_film;
mod memory;
mod outcome;
mod paired;
mod pixels;
mod plan;
mod replicates;
mod several;
mod slices;
mod start;
mod tiles;
mod trace;
mod twice;
mod vulkan;

use std::sync::atomic::AtomicBool;

use crate::gpu::Device;
pub use crate::gpu::Selector;
use crate::kernel::Spirv;
pub use crate::part::Dropped;
pub use best::{Best, best, best_of};
pub use classes::light_classes;
pub use course::{End, ErrorAt, Until, look};
pub use error::RenderError;
pub use follow::Watch;
use host_film::{HostFilm, empty_part};
pub use job::{Job, KernelChoice, Target};
pub use layers::{layer_samples, layers};
use light_film::LightFilm;
pub use outcome::{NEAREST, Outcome, Progress, SetUp, Stats};
pub use paired::paired;
use pixels::Pixels;
pub use plan::{ArrayPlan, HierarchyPlan, Plan, PlanLimits, StatePlan};
pub use replicates::{Engine, Replicates, Took};
pub use several::render_several;
pub use slices::WANTED as DISPATCH_TIME;
pub use start::{Start, State};
pub use trace::{Trace, chain, techniques, trace};
pub use vulkan::{DispatchLimits, statistics};

/// Renders the job, calling `progress` after each slice of samples. Once `stop` is set, or the job's limit is reached,
/// it finishes the current sample index in every pixel and returns the result: the same, to the bit, as that of a job
/// with that many samples.
pub fn render(
    job: &Job,
    target: &Target,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    render_from(job, target, &Start::At(0), stop, &mut |p| progress(p))
}

/// Renders as [`render`] does, from `start` on. A device that fails is opened again, once; if it fails again, the
/// result so far is returned, if every pixel has a sample.
pub fn render_from(
    job: &Job,
    target: &Target,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    match target {
        Target::Vulkan(selector) => {
            memory::check::<f32>(job, 1)?;
            twice::render(job, selector, start, stop, watch)
        }
        Target::CpuF32 => {
            memory::check::<f32>(job, 1)?;
            cpu::render::<f32>(job, "cpu-f32", start, stop, watch)
        }
        Target::CpuF64 => {
            memory::check::<f64>(job, 1)?;
            cpu::render::<f64>(job, "cpu-f64", start, stop, watch)
        }
    }
}

/// Renders as [`render`] does, on a device that is already open; `limits` do not influence the picture.
pub fn render_on(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    let start = Start::At(0);
    let rendered = vulkan::render(job, device, limits, &start, stop, &mut |p| progress(p));
    rendered.map_err(|failed| failed.error)
}

/// The kernels that render the job on `device`, composed and compiled for its scene and settings.
pub fn kernels(job: &Job, device: &Device) -> Result<Vec<Spirv>, RenderError> {
    Plan::new(job, PlanLimits::of(device))?.compile()
}

//! One path, event by event, on two renderers side by side.

mod event;
mod side_by_side;

use super::vulkan;
use super::{Job, RenderError, Target};
use crate::gpu::Device;
use crate::reference::integrator::path::trace_path;
use crate::reference::math::Real;
use crate::reference::path::SampleId;
use crate::reference::world::World;
use event::{Event, Events, Names, event};
pub use side_by_side::Trace;

/// The path of sample `index` of the pixel at column and row `pixel`.
///
/// # Errors
/// As those of a rendering.
pub fn trace(
    job: &Job,
    target: &Target,
    pixel: [u32; 2],
    index: u32,
) -> Result<Trace, RenderError> {
    let f32_path = reference::<f32>(job, pixel, index);
    let (other, name, tolerance) = match target {
        Target::Vulkan(selector) => {
            let device = Device::open(selector)?;
            let records = vulkan::records(job, &device, pixel, index)?;
            let names = Names(job.prepared);
            let events = records.iter().map(|r| event(names, r)).collect();
            (events, device.info().name.clone(), 0.0)
        }
        Target::CpuF32 | Target::CpuF64 => (
            reference::<f64>(job, pixel, index),
            "cpu-f64".to_owned(),
            1e-3,
        ),
    };
    Ok(Trace {
        names: [name, "cpu-f32".to_owned()],
        paths: [other, f32_path],
        tolerance,
    })
}

fn reference<F: Real>(job: &Job, [column, row]: [u32; 2], sample: u32) -> Vec<Event> {
    let world = World::<F>::new(job.prepared);
    let id = SampleId {
        column,
        row,
        pixel: row * job.prepared.camera.width + column,
        sample,
        seed: job.seed,
    };
    let mut events = Events::new(Names(job.prepared));
    trace_path(&world, &job.settings, id, &mut events);
    events.told()
}

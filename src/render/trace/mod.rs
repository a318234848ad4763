//! One path, event by event, on two renderers side by side.

mod bidirectional;
pub mod chain;
mod event;
mod paths;
mod side_by_side;
pub mod techniques;

use super::both::both_paths;
use super::paired::path;
use super::tiles::Tile;
use super::vulkan::{self, Outcomes};
use super::{Job, RenderError, Target};
use crate::gpu::Device;
use crate::reference::integrator::path::trace_path;
use crate::reference::math::Real;
use crate::reference::world::World;
use crate::sample::Address;
use crate::settings::Integrator;
use event::{Event, Events, Names, event};
pub use side_by_side::Trace;

/// Smallest relative difference between f32 and f64 that is reported.
const REFERENCES_APART: f64 = 1e-3;

/// The letters of a bidirectional trace.
const LEGEND: &str = "s: vertices of the light path; t: of the eye path. A connection that found light is followed by all ways \
     to find its path, each with its density p and its weight p²/Σp²; * marks the one taken.";

/// The path of sample `index` of the pixel at column and row `pixel`.
///
/// # Errors
/// Those of a rendering.
pub fn trace(
    job: &Job,
    target: &Target,
    pixel: [u32; 2],
    index: u32,
) -> Result<Trace, RenderError> {
    if job.settings.estimator.integrator == Integrator::Bidirectional {
        return both(job, target, Address { pixel, index });
    }
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
            REFERENCES_APART,
        ),
    };
    Ok(Trace {
        names: [name, "cpu-f32".to_owned()],
        paths: [other, f32_path],
        tolerance,
        notes: Vec::new(),
    })
}

/// Both paths of a bidirectional sample, of which devices record nothing: by both references, with the device's result
/// for the same sample.
fn both(job: &Job, target: &Target, address: Address) -> Result<Trace, RenderError> {
    let device = match target {
        Target::Vulkan(selector) => Some(on_device(job, &Device::open(selector)?, address)?),
        Target::CpuF32 | Target::CpuF64 => None,
    };
    Ok(Trace {
        names: ["cpu-f64", "cpu-f32"].map(str::to_owned),
        paths: [
            both_of_reference::<f64>(job, address),
            both_of_reference::<f32>(job, address),
        ],
        tolerance: REFERENCES_APART,
        notes: [LEGEND.to_owned()].into_iter().chain(device).collect(),
    })
}

fn both_of_reference<F: Real>(job: &Job, address: Address) -> Vec<Event> {
    let world = World::<F>::new(job.prepared);
    let names = Names(job.prepared);
    let mut events = bidirectional::Events::new(&world, &job.settings, names);
    let brought = both_paths(job, &world, job.sample(address), &mut events);
    events.finish(brought.radiance)
}

/// How a device's sample compares with that of cpu-f32.
fn on_device(job: &Job, device: &Device, address: Address) -> Result<String, RenderError> {
    let [x, y] = address.pixel;
    let pixel = Tile {
        x,
        y,
        width: 1,
        height: 1,
    };
    let job = Job { crop: None, ..*job };
    let mut outcomes = Outcomes::new(&job, pixel, device, 1, 1)?;
    let found = outcomes.of(0, address.index, 1)?[0][0];
    let expected = path::<f32>(&job, &World::new(job.prepared), address);
    let name = &device.info().name;
    Ok(if found == expected {
        format!("{name}: the same decisions and radiance as cpu-f32, to the bit")
    } else {
        let decides = match found.signature == expected.signature {
            true => "the same decisions as cpu-f32",
            false => "different decisions from cpu-f32",
        };
        let [a, b] = [found.radiance, expected.radiance];
        format!("{name}: {decides}; radiance of splats and eye path {a:?}, by cpu-f32 {b:?}")
    })
}

fn reference<F: Real>(job: &Job, pixel: [u32; 2], index: u32) -> Vec<Event> {
    let world = World::<F>::new(job.prepared);
    let id = job.sample(Address { pixel, index });
    let mut events = Events::new(Names(job.prepared));
    trace_path(&world, &job.settings, id, &mut events);
    events.finish()
}

//! The same samples by a Vulkan device and by both references, a slice of samples of a tile at a time.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::both::{Brought, both_paths};
use super::tiles::Tile;
use super::vulkan::Outcomes;
use super::{Job, Progress, RenderError};
use crate::gpu::Device;
use crate::reference::integrator::bidirectional::{self, signature::brought};
use crate::reference::integrator::path::signature::Signature;
use crate::reference::integrator::path::trace_path;
use crate::reference::math::Real;
use crate::reference::path::SampleId;
use crate::reference::world::World;
use crate::sample::{Address, PairedSample, Path};
use crate::settings::Integrator;

/// Pixels and samples of one slice: 2¹⁷ paths of some 150 bytes in all, for any picture.
const TILE: u32 = 1 << 13;
const SLICE: u32 = 16;

/// Renders each sample of the job three times and passes it to `take`; returns whether `stop` ended it early.
///
/// # Errors
/// Those of a rendering on `device`.
pub fn paired(
    job: &Job,
    device: &Device,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
    take: &mut dyn FnMut(&PairedSample),
) -> Result<bool, RenderError> {
    let area = job.area();
    let job = &match job.settings.estimator.integrator {
        // Splats go to any pixel, also outside a crop.
        Integrator::Bidirectional => Job { crop: None, ..*job },
        _ => *job,
    };
    let references = References::new(job);
    let mut outcomes = Outcomes::new(job, area, device, TILE, SLICE.min(job.spp))?;
    let tiles = outcomes.tiles();
    for done in (0..job.spp).step_by(SLICE as usize) {
        let slice = SLICE.min(job.spp - done);
        for (i, tile) in tiles.iter().enumerate() {
            if stop.load(Ordering::Relaxed) {
                return Ok(true);
            }
            let outcomes = outcomes.of(i, done, slice)?;
            let samples = references.samples(tile, done, &outcomes);
            samples.iter().flatten().for_each(&mut *take);
            let part = (i + 1) as f64 / tiles.len() as f64;
            progress(Progress {
                samples_done: if part == 1.0 { done + slice } else { done },
                spp: job.spp,
                fraction: (f64::from(done) + part * f64::from(slice)) / f64::from(job.spp),
            });
        }
    }
    Ok(false)
}

/// The scene for both references.
struct References<'a> {
    job: &'a Job<'a>,
    f32: World<f32>,
    f64: World<f64>,
}

impl<'a> References<'a> {
    fn new(job: &'a Job) -> Self {
        Self {
            job,
            f32: World::new(job.prepared),
            f64: World::new(job.prepared),
        }
    }

    /// The samples from index `first` on of each pixel of a tile, paired with the device's `outcomes`.
    fn samples(&self, tile: &Tile, first: u32, outcomes: &[Vec<Path>]) -> Vec<Vec<PairedSample>> {
        let pixel = |(k, outcomes): (usize, &Vec<Path>)| {
            let k = k as u32;
            let pixel = tile.pixel(k);
            let sample = |(index, &device)| self.sample(Address { pixel, index }, device);
            (first..).zip(outcomes).map(sample).collect()
        };
        outcomes.par_iter().enumerate().map(pixel).collect()
    }

    fn sample(&self, address: Address, device: Path) -> PairedSample {
        PairedSample {
            address,
            device,
            f32: path(self.job, &self.f32, address),
            f64: path(self.job, &self.f64, address),
        }
    }
}

/// A sample by the reference.
pub(super) fn path<F: Real>(job: &Job, world: &World<F>, address: Address) -> Path {
    let id = job.sample(address);
    match job.settings.estimator.integrator {
        Integrator::Bidirectional => sample_of_both(job, world, id),
        _ => eye_path(job, world, id),
    }
}

fn eye_path<F: Real>(job: &Job, world: &World<F>, id: SampleId) -> Path {
    let mut signature = Signature::default();
    let result = trace_path(world, &job.settings, id, &mut signature);
    Path {
        radiance: result.radiance.f64().to_array(),
        signature: signature.word(),
    }
}

fn sample_of_both<F: Real>(job: &Job, world: &World<F>, id: SampleId) -> Path {
    let mut signature = bidirectional::signature::Signature::default();
    let Brought { radiance, splats } = both_paths(job, world, id, &mut signature);
    Path {
        radiance: brought(radiance, &splats).to_array(),
        signature: signature.word(&splats),
    }
}

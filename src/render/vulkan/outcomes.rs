//! The value of every single sample on a device, before the film adds it.

use super::light::LightRun;
use super::light_paths::Arrived;
use super::limits::DispatchLimits;
use super::path::PathRun;
use super::path_film::TileFilm;
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::layout::PathOutcome;
use crate::reference::integrator::bidirectional::signature::{brought, sample_signature};
use crate::reference::integrator::light::Splat;
use crate::reference::math::Vec3;
use crate::render::tiles::{Tile, tiles};
use crate::render::{Job, RenderError};
use crate::sample::Path;
use crate::settings::Integrator;

/// Kernels that report each sample, and buffers for the samples of one tile.
pub struct Outcomes<'a> {
    run: Run<'a>,
    /// Samples a pixel that fit.
    room: u32,
}

enum Run<'a> {
    Path(Box<PathRun<'a>>),
    Bidirectional(Box<LightRun<'a>>),
}

impl<'a> Outcomes<'a> {
    /// Tiles of at most `tile_pixels` of `area`, `room` samples a pixel at a time. `job` has no crop but `area`; for
    /// bidirectional paths it has none, because a sample's splats go to any pixel.
    pub fn new(
        job: &'a Job<'a>,
        area: Tile,
        device: &'a Device,
        tile_pixels: u32,
        room: u32,
    ) -> Result<Self, RenderError> {
        let features = job.features();
        let limits = DispatchLimits::of(device)?;
        let limits = DispatchLimits {
            tile_pixels: limits.tile_pixels.min(tile_pixels),
            ..limits
        };
        let recording = Recording::Outcomes(room);
        let run = match features.integrator {
            Integrator::Bidirectional => {
                let tiles = tiles(area, limits.tile_pixels.max(1));
                let run = LightRun::recording(job, device, &features, limits, tiles, recording)?;
                Run::Bidirectional(Box::new(run))
            }
            _ => {
                let run = PathRun::recording(job, device, &features, limits, recording)?;
                Run::Path(Box::new(run))
            }
        };
        Ok(Self { run, room })
    }

    pub fn tiles(&self) -> Vec<Tile> {
        match &self.run {
            Run::Path(run) => run.host.tiles.iter().map(|t| t.tile).collect(),
            Run::Bidirectional(run) => run.tiles.clone(),
        }
    }

    /// The samples from `first` on of each pixel of a tile, row by row: `count` ≤ `room` of them, one after the other.
    pub fn of(
        &mut self,
        tile: usize,
        first: u32,
        count: u32,
    ) -> Result<Vec<Vec<Path>>, RenderError> {
        match &mut self.run {
            Run::Path(run) => of_paths(run, self.room, tile, first, count),
            Run::Bidirectional(run) => of_both(run, tile, first, count),
        }
    }
}

fn of_paths(
    run: &mut PathRun,
    room: u32,
    tile: usize,
    first: u32,
    count: u32,
) -> Result<Vec<Vec<Path>>, RenderError> {
    run.restart(tile, first)?;
    run.advance_tile(tile, count)?;
    let TileFilm { tile, .. } = &run.host.tiles[tile];
    let all = run.outcomes()?;
    let path = |outcome: &PathOutcome| Path {
        radiance: outcome.radiance.map(f64::from),
        signature: outcome.signature,
    };
    let pixels = all.chunks(room as usize).take(tile.pixels() as usize);
    Ok(pixels
        .map(|samples| samples[..count as usize].iter().map(path).collect())
        .collect())
}

fn of_both(
    run: &mut LightRun,
    tile: usize,
    first: u32,
    count: u32,
) -> Result<Vec<Vec<Path>>, RenderError> {
    let threads = run.tiles[tile].pixels() as usize;
    let samples = threads * count as usize;
    let place = |a: &Arrived| (a.index - first) as usize * threads + a.thread as usize;
    let mut splats: Vec<Vec<Splat<f32>>> = vec![Vec::new(); samples];
    let mut seen = vec![None; samples];
    run.trace(
        tile,
        first..first + count,
        &mut |a| splats[place(&a)].push(a.splat),
        &mut |a, signature| seen[place(&a)] = Some((a.splat.value, signature)),
    )?;
    let decided = match &run.eye {
        Some(eye) => eye.decided(samples)?,
        None => Vec::new(),
    };
    let sample = |at: usize| {
        let (radiance, eye) = seen[at].unwrap_or((Vec3::zero(), 0));
        Path {
            radiance: brought(radiance, &splats[at]).to_array(),
            signature: sample_signature(decided[at], &splats[at], eye),
        }
    };
    let pixel = |thread| (0..count as usize).map(move |k| k * threads + thread);
    Ok((0..threads)
        .map(|thread| pixel(thread).map(sample).collect())
        .collect())
}

//! Path tracing on a device: the pixels in tiles, each pixel's samples by its own thread.

use std::time::{Duration, Instant};

use super::kernel::Kernel;
use super::limits::DispatchLimits;
use super::rendering::{Costs, Rendering};
use super::tile_film::{DeviceFilm, PathFilm, TileFilm, buffer};
use crate::features::Features;
use crate::gpu::{Buffer, Device};
use crate::kernel::scene::Recording;
use crate::layout::{PathOutcome, Record, Slice};
use crate::render::plan::{PathPlan, StatePlan, thread_tiles};
use crate::render::tiles::Tile;
use crate::render::{Job, RenderError};

/// A scene's path tracer, its buffers, and the films of all tiles.
///
/// The device holds the film of the tile under way, the host all of them: 8192 × 8192 pixels would not fit the
/// memory of many a device.
pub struct PathRun<'a> {
    job: &'a Job<'a>,
    kernel: Kernel<'a>,
    film: DeviceFilm,
    /// Events of one path, or outcomes of all.
    recorded: Option<Buffer>,
    pub host: PathFilm,
    budget: u32,
    /// Index of the first sample.
    pub sample_begin: u32,
}

impl<'a> Rendering<'a> for PathRun<'a> {
    type Film = PathFilm;

    fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
    ) -> Result<Self, RenderError> {
        Self::recording(job, device, features, limits, Recording::Nothing)
    }

    fn compile(&mut self) -> Result<Duration, RenderError> {
        let start = Instant::now();
        self.dispatch(0, 0)?;
        self.kernel.costs.gpu_time = Duration::ZERO;
        Ok(start.elapsed())
    }

    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let tiles = self.host.tiles.len();
        let mut longest = Duration::ZERO;
        for tile in 0..tiles {
            longest = longest.max(self.advance_tile(tile, samples)?);
            progress((tile + 1) as f64 / tiles as f64);
        }
        Ok(longest)
    }

    fn film(&self) -> &Self::Film {
        &self.host
    }

    fn empty(&self) -> Self::Film {
        self.host.empty()
    }

    fn exchange(&mut self, film: Self::Film, seed: u32) -> Result<Self::Film, RenderError> {
        self.kernel.scene.reseed(self.job.prepared, seed)?;
        let before = std::mem::replace(&mut self.host, film);
        // Of several tiles, each is uploaded when its turn comes.
        if let [tile] = &self.host.tiles[..] {
            self.film.upload(tile)?;
        }
        Ok(before)
    }

    fn costs(&self) -> &Costs {
        &self.kernel.costs
    }

    fn buffers(&self) -> Vec<(String, u64)> {
        self.kernel
            .buffers(self.film.buffers().chain(&self.recorded))
    }
}

impl<'a> PathRun<'a> {
    /// With what is written down of its paths beside the film.
    pub fn recording(
        job: &'a Job<'a>,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
        recording: Recording,
    ) -> Result<Self, RenderError> {
        let tiles = thread_tiles(job, limits.tile_pixels);
        let largest = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        let plan = PathPlan::new(features, largest, recording);
        let read_first = limits.read_first;
        let state = StatePlan::Path(plan);
        let mut kernel = Kernel::new(job, device, features, recording, read_first, &state)?;
        let start = Instant::now();
        let film = DeviceFilm::new(device, &plan)?;
        let recorded = plan.recorded.map(|r| buffer(device, &r)).transpose()?;
        kernel.costs.set_up.upload += start.elapsed().as_secs_f64();
        Ok(Self {
            job,
            kernel,
            film,
            recorded,
            host: PathFilm::new(job.area(), tiles, features.keeps_moments()),
            budget: limits.budget.max(1),
            sample_begin: 0,
        })
    }

    /// Brings every pixel of a tile to `sample_end` samples; returns the longest dispatch.
    pub fn advance_tile(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        if self.host.tiles.len() > 1 {
            self.film.upload(&self.host.tiles[tile])?;
        }
        let mut longest = Duration::ZERO;
        loop {
            longest = longest.max(self.dispatch(tile, sample_end)?);
            let kept = &mut self.host.tiles[tile];
            self.film.read_pixels(kept)?;
            let loops: u64 = kept.pixels.iter().map(|p| u64::from(p.loops)).sum();
            if loops > 0 {
                return Err(RenderError::Loops(loops));
            }
            if kept.pixels.iter().all(|p| p.samples == sample_end) {
                self.film.read_moments(kept)?;
                return Ok(longest);
            }
        }
    }

    /// Begins a tile anew, at the sample of index `sample_begin`.
    pub fn restart(&mut self, tile: usize, sample_begin: u32) -> Result<(), RenderError> {
        self.sample_begin = sample_begin;
        self.host.tiles[tile].clear();
        self.film.upload(&self.host.tiles[tile])
    }

    fn dispatch(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        let TileFilm { tile, .. } = &self.host.tiles[tile];
        let slice = Slice {
            tile_x: tile.x,
            tile_y: tile.y,
            tile_width: tile.width,
            tile_height: tile.height,
            sample_begin: self.sample_begin,
            sample_end,
            budget: self.budget,
            eye_medium: self.job.prepared.eye_medium,
        };
        let state = self.film.buffers().chain(&self.recorded);
        self.kernel.dispatch(0, state, &slice, tile.pixels())
    }

    /// What the samples of the tile that was advanced last came to: as many a pixel as the kernel has room for.
    pub fn outcomes(&self) -> Result<Vec<PathOutcome>, RenderError> {
        let buffer = self.recorded.as_ref();
        let bytes = buffer.map_or(Ok(Vec::new()), Buffer::read)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    /// The events written down, in order.
    pub fn records(&self) -> Result<Vec<Record>, RenderError> {
        let paths = self.film.read_paths()?;
        let Some(buffer) = &self.recorded else {
            return Ok(Vec::new());
        };
        let mut records: Vec<Record> = bytemuck::pod_collect_to_vec(&buffer.read()?);
        records.truncate(paths[0].recorded as usize);
        Ok(records)
    }
}

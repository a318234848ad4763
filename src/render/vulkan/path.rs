//! Path tracing on a device: the pixels in tiles, each pixel's samples by its own thread.

use std::time::{Duration, Instant};

use super::device_film::{DeviceFilm, buffer};
use super::kernel::Kernel;
use super::limits::DispatchLimits;
use super::path_film::{PathFilm, TileFilm};
use super::rendering::{Costs, Rendering};
use crate::features::Features;
use crate::gpu::{Buffer, Device};
use crate::kernel::scene::Recording;
use crate::layout::{PathOutcome, Record, Slice};
use crate::part::Part;
use crate::render::plan::{PathPlan, StatePlan, thread_tiles};
use crate::render::tiles::Tile;
use crate::render::{Job, RenderError, empty_part};

/// A scene's path tracer, its buffers, and the films of all tiles.
///
/// The device stores the film of the current tile, the host all of them: 8192 × 8192 pixels would not fit the
/// memory of many devices.
pub struct PathRun<'a> {
    job: &'a Job<'a>,
    kernel: Kernel<'a>,
    film: DeviceFilm,
    /// Events of one path, or outcomes of all.
    recorded: Option<Buffer>,
    pub host: PathFilm,
    budget: u32,
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
        self.dispatch(self.host.tiles[0].tile, 0)?;
        self.kernel.costs.gpu_time = Duration::ZERO;
        Ok(start.elapsed())
    }

    fn go_on(&mut self, part: Part<f32>) -> Result<(), RenderError> {
        self.host = self.host.going_on(part);
        self.take_up()
    }

    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let begin = self.host.done();
        let mut longest = Duration::ZERO;
        while self.host.done() < samples {
            let done = self.host.done();
            let stop = self.host.stop(samples);
            let mut part = |tiles: f64| {
                let done = f64::from(done - begin) + tiles * f64::from(stop - done);
                progress(done / f64::from(samples - begin));
            };
            longest = longest.max(self.advance_to(stop, &mut part)?);
        }
        Ok(longest)
    }

    fn film(&self) -> &Self::Film {
        &self.host
    }

    fn empty(&self) -> Self::Film {
        self.host.going_on(empty_part(self.job, 0))
    }

    fn exchange(&mut self, film: Self::Film, seed: u32) -> Result<Self::Film, RenderError> {
        self.kernel.scene.reseed(self.job.prepared, seed)?;
        let before = std::mem::replace(&mut self.host, film);
        self.take_up()?;
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
    /// A run that records its paths in addition to the film.
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
        let plan_limits = limits.plan(device);
        let state = StatePlan::Path(plan);
        let mut kernel = Kernel::new(job, device, features, recording, plan_limits, &state)?;
        let start = Instant::now();
        let film = DeviceFilm::new(device, &plan)?;
        let recorded = plan.recorded.map(|r| buffer(device, &r)).transpose()?;
        kernel.costs.set_up.upload += start.elapsed().as_secs_f64();
        Ok(Self {
            job,
            kernel,
            film,
            recorded,
            host: PathFilm::new(job.area(), tiles, empty_part(job, 0)),
            budget: limits.budget.max(1),
        })
    }

    /// Brings the pixels of all tiles to the sample of index `stop`, or on an error those of none.
    fn advance_to(
        &mut self,
        stop: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let samples = stop - self.host.block_begin();
        let count = self.host.tiles.len();
        let mut longest = Duration::ZERO;
        let mut grown = Vec::with_capacity(count);
        for tile in 0..count {
            let (film, time) = self.grown(tile, samples)?;
            grown.push(film);
            longest = longest.max(time);
            progress((tile + 1) as f64 / count as f64);
        }
        self.host.tiles = grown;
        if self.host.settle() {
            self.take_up()?;
        }
        Ok(longest)
    }

    /// Brings every pixel of a tile to `samples` of its current block.
    pub fn advance_tile(&mut self, tile: usize, samples: u32) -> Result<(), RenderError> {
        let (film, _) = self.grown(tile, samples)?;
        self.host.tiles[tile] = film;
        Ok(())
    }

    /// Restarts a tile, at the sample of index `begin`.
    pub fn restart(&mut self, tile: usize, begin: u32) -> Result<(), RenderError> {
        self.host.restart(tile, empty_part(self.job, begin));
        self.film.upload(&self.host.tiles[tile])
    }

    /// Makes the device continue with the film of the host. With several tiles, each is uploaded when its turn comes.
    fn take_up(&mut self) -> Result<(), RenderError> {
        match &self.host.tiles[..] {
            [tile] => self.film.upload(tile),
            _ => Ok(()),
        }
    }

    /// A tile with `samples` of the current block in every pixel, and the longest dispatch of that.
    fn grown(&mut self, tile: usize, samples: u32) -> Result<(TileFilm, Duration), RenderError> {
        if self.host.tiles.len() > 1 {
            self.film.upload(&self.host.tiles[tile])?;
        }
        let tile = self.host.tiles[tile].tile;
        let mut longest = Duration::ZERO;
        loop {
            longest = longest.max(self.dispatch(tile, samples)?);
            if self.film.read_pixels(tile, samples)? {
                let grown = self
                    .film
                    .read(tile, self.host.block_begin(), self.host.keeps())?;
                return Ok((grown, longest));
            }
        }
    }

    /// Makes every pixel of a tile continue to `sample_end` samples of its block.
    fn dispatch(&mut self, tile: Tile, sample_end: u32) -> Result<Duration, RenderError> {
        let slice = Slice {
            tile_x: tile.x,
            tile_y: tile.y,
            tile_width: tile.width,
            tile_height: tile.height,
            sample_begin: self.host.block_begin(),
            sample_end,
            budget: self.budget,
            eye_medium: self.job.prepared.eye_medium,
        };
        let state = self.film.buffers().chain(&self.recorded);
        self.kernel.dispatch(0, state, &slice, tile.pixels())
    }

    /// The values of the samples of the tile that was advanced last: as many a pixel as fit.
    pub fn outcomes(&self) -> Result<Vec<PathOutcome>, RenderError> {
        let buffer = self.recorded.as_ref();
        let bytes = buffer.map_or(Ok(Vec::new()), Buffer::read)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    /// The recorded events, in order.
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

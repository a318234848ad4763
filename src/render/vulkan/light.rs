//! Light tracing on a device: light paths in tiles, their splats added to the film by the host.

use std::time::{Duration, Instant};

use super::kernel::Kernel;
use super::rendering::{Costs, Rendering};
use super::tile_film::buffer;
use crate::features::Features;
use crate::gpu::{Buffer, Device};
use crate::kernel::scene::{Recording, SPLATS};
use crate::layout::{self, LightLane, LightSlice, LightState};
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::math::vec3;
use crate::render::plan::{LightPlan, thread_tiles};
use crate::render::tiles::Tile;
use crate::render::{DispatchLimits, Job, LightFilm, RenderError};

/// Light paths of one pass over the picture, at most, unless one sample index has more: their splats are kept until they
/// can be added in order.
const PASS: u64 = 1 << 20;

/// A scene's light tracer, its buffers, and the film.
pub struct LightRun<'a> {
    job: &'a Job<'a>,
    kernel: Kernel<'a>,
    paths: Buffer,
    lanes: Buffer,
    splats: Buffer,
    /// Of light paths: a path's number is a pixel's, wherever its splats go.
    tiles: Vec<Tile>,
    film: LightFilm<f32>,
    budget: u32,
}

impl<'a> Rendering<'a> for LightRun<'a> {
    type Film = LightFilm<f32>;

    fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
    ) -> Result<Self, RenderError> {
        let tiles = thread_tiles(job, limits.tile_pixels);
        let largest = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        let plan = LightPlan::new(largest);
        let read_first = limits.read_first;
        let kernel = Kernel::new::<LightSlice>(
            job,
            device,
            features,
            Recording::Nothing,
            read_first,
            plan.plans(),
        )?;
        let start = Instant::now();
        let mut run = Self {
            job,
            kernel,
            paths: buffer(device, &plan.paths)?,
            lanes: buffer(device, &plan.lanes)?,
            splats: buffer(device, &plan.splats)?,
            tiles,
            film: LightFilm::new(job),
            budget: limits.budget.max(1),
        };
        run.kernel.costs.set_up.upload += start.elapsed().as_secs_f64();
        Ok(run)
    }

    fn compile(&mut self) -> Result<Duration, RenderError> {
        let start = Instant::now();
        self.dispatch(0, 0)?;
        self.kernel.costs.gpu_time = Duration::ZERO;
        Ok(start.elapsed())
    }

    /// Pass after pass over the light paths of all tiles; what they bring is added in the order of (sample, light path,
    /// vertex), which no tile and no slice changes.
    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let begin = self.film.samples();
        let pass = (PASS / u64::from(self.job.whole().pixels())).max(1) as u32;
        let mut longest = Duration::ZERO;
        while self.film.samples() < samples {
            let first = self.film.samples();
            let end = first + pass.min(samples - first);
            let mut arrived = vec![Vec::new(); (end - first) as usize];
            for tile in 0..self.tiles.len() {
                longest = longest.max(self.trace(tile, first..end, &mut arrived)?);
                if let [only] = &mut arrived[..] {
                    only.drain(..).for_each(|splat| self.film.splat(splat));
                }
                let tiles = (tile + 1) as f64 / self.tiles.len() as f64;
                let done = f64::from(first - begin) + tiles * f64::from(end - first);
                progress(done / f64::from(samples - begin));
            }
            for splats in arrived {
                splats.into_iter().for_each(|splat| self.film.splat(splat));
                self.film.end_sample();
            }
        }
        Ok(longest)
    }

    fn film(&self) -> &Self::Film {
        &self.film
    }

    fn empty(&self) -> Self::Film {
        LightFilm::new(self.job)
    }

    fn exchange(&mut self, film: Self::Film, seed: u32) -> Result<Self::Film, RenderError> {
        self.kernel.scene.reseed(self.job.prepared, seed)?;
        Ok(std::mem::replace(&mut self.film, film))
    }

    fn costs(&self) -> &Costs {
        &self.kernel.costs
    }

    fn buffers(&self) -> Vec<(String, u64)> {
        self.kernel
            .buffers([&self.paths, &self.lanes, &self.splats].into_iter())
    }
}

/// A splat of one dispatch, the thread of its light path, and its sample index.
struct Arrived {
    thread: u32,
    index: u32,
    splat: Splat<f32>,
}

impl LightRun<'_> {
    /// Follows the light paths of a tile and of some sample indices to their ends; `arrived` gets the splats of each index
    /// in the order of light path and vertex.
    fn trace(
        &mut self,
        tile: usize,
        indices: std::ops::Range<u32>,
        arrived: &mut [Vec<Splat<f32>>],
    ) -> Result<Duration, RenderError> {
        self.upload(tile, indices.start)?;
        let mut longest = Duration::ZERO;
        let mut all = Vec::new();
        loop {
            longest = longest.max(self.dispatch(tile, indices.end)?);
            let lanes = self.read_lanes(tile)?;
            self.read_splats(&lanes, &mut all)?;
            if lanes.iter().all(|lane| lane.unfinished == 0) {
                break;
            }
        }
        // A path that was handed over has splats in several dispatches; the sort keeps their order.
        all.sort_by_key(|a| a.thread);
        for Arrived { index, splat, .. } in all {
            arrived[(index - indices.start) as usize].push(splat);
        }
        Ok(longest)
    }

    /// Threads that have begun no light path from sample index `index` on.
    fn upload(&self, tile: usize, index: u32) -> Result<(), RenderError> {
        let fresh = LightState {
            index,
            ..LightState::default()
        };
        let states = vec![fresh; self.tiles[tile].pixels() as usize];
        Ok(self.paths.write(bytemuck::cast_slice(&states))?)
    }

    fn dispatch(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        let tile = self.tiles[tile];
        let window = self.film.window();
        let slice = LightSlice {
            tile_x: tile.x,
            tile_y: tile.y,
            tile_width: tile.width,
            tile_height: tile.height,
            film_x: window.x,
            film_y: window.y,
            film_width: window.width,
            film_height: window.height,
            sample_end,
            budget: self.budget,
            ..LightSlice::default()
        };
        let state = [&self.paths, &self.lanes, &self.splats].into_iter();
        self.kernel.dispatch(state, &slice, tile.pixels())
    }

    /// What each thread did in the last dispatch.
    fn read_lanes(&mut self, tile: usize) -> Result<Vec<LightLane>, RenderError> {
        let mut lanes = vec![LightLane::default(); self.tiles[tile].pixels() as usize];
        self.lanes.read_into(bytemuck::cast_slice_mut(&mut lanes))?;
        let loops: u64 = lanes.iter().map(|lane| u64::from(lane.loops)).sum();
        if loops > 0 {
            return Err(RenderError::Loops(loops));
        }
        for lane in &lanes {
            self.film.count(LightCounts {
                rays: u64::from(lane.rays),
                long_paths: u64::from(lane.long_paths),
                underflows: u64::from(lane.underflows),
                nan: u64::from(lane.nan),
                infinite: u64::from(lane.infinite),
            });
        }
        Ok(lanes)
    }

    /// The splats of the last dispatch, slot after slot as they lie: slot i of every thread before slot i + 1 of any.
    fn read_splats(
        &self,
        lanes: &[LightLane],
        arrived: &mut Vec<Arrived>,
    ) -> Result<(), RenderError> {
        let slots = lanes.iter().map(|lane| lane.splats).max().unwrap_or(0);
        debug_assert!(slots <= SPLATS);
        let mut splats = vec![layout::Splat::default(); slots as usize * lanes.len()];
        self.splats
            .read_into(bytemuck::cast_slice_mut(&mut splats))?;
        let slots = splats.chunks(lanes.len()).zip(0..);
        for (slot, number) in slots {
            for ((splat, lane), thread) in slot.iter().zip(lanes).zip(0..) {
                if number < lane.splats {
                    let [r, g, b] = splat.value;
                    arrived.push(Arrived {
                        thread,
                        index: splat.index,
                        splat: Splat {
                            value: vec3(r, g, b),
                            pixel: splat.pixel,
                        },
                    });
                }
            }
        }
        Ok(())
    }
}

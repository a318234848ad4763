//! Light paths of a tile on a device, followed to their ends, and their splats.

use std::ops::Range;
use std::time::{Duration, Instant};

use super::device_film::buffer;
use super::kernel::Kernel;
use crate::gpu::{Buffer, Device};
use crate::kernel::scene::SPLATS;
use crate::layout::{self, LightLane, LightSlice, LightState};
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::math::vec3;
use crate::render::plan::LightPlan;
use crate::render::tiles::Tile;
use crate::render::{LightFilm, RenderError};

/// The buffers of light paths.
pub struct LightPaths {
    paths: Buffer,
    pub lanes: Buffer,
    splats: Buffer,
}

/// A contribution of a thread's path of one sample index.
pub struct Arrived {
    pub thread: u32,
    pub index: u32,
    pub splat: Splat<f32>,
}

impl LightPaths {
    /// As planned.
    pub fn new(
        device: &Device,
        plan: &LightPlan,
        kernel: &mut Kernel,
    ) -> Result<Self, RenderError> {
        let start = Instant::now();
        let paths = Self {
            paths: buffer(device, &plan.paths)?,
            lanes: buffer(device, &plan.lanes)?,
            splats: buffer(device, &plan.splats)?,
        };
        kernel.costs.set_up.upload += start.elapsed().as_secs_f64();
        Ok(paths)
    }

    /// In the order of their bindings.
    pub fn buffers(&self) -> [&Buffer; 3] {
        [&self.paths, &self.lanes, &self.splats]
    }

    /// Follows the light paths of a tile and of some sample indices, those of `slice`, to their ends with pipeline 0,
    /// which writes to `beside` too; returns their splats, those of each index in the order of light path and vertex.
    pub fn trace(
        &self,
        kernel: &mut Kernel,
        beside: &[&Buffer],
        slice: &LightSlice,
        film: &mut LightFilm<f32>,
        take: &mut impl FnMut(Arrived),
    ) -> Result<Duration, RenderError> {
        let threads = slice.tile_width * slice.tile_height;
        self.upload(threads, slice.sample_begin)?;
        let mut longest = Duration::ZERO;
        let mut all = Vec::new();
        loop {
            let state = self.buffers().into_iter().chain(beside.iter().copied());
            longest = longest.max(kernel.dispatch(0, state, slice, threads)?);
            let lanes = read_lanes(&self.lanes, threads, film)?;
            self.read_splats(&lanes, &mut all)?;
            if lanes.iter().all(|lane| lane.unfinished == 0) {
                break;
            }
        }
        // A path that was continued has splats in several dispatches; the sort keeps their order.
        all.sort_by_key(|a| a.thread);
        all.into_iter().for_each(take);
        Ok(longest)
    }

    /// Threads that have begun no light path from sample index `index` on.
    fn upload(&self, threads: u32, index: u32) -> Result<(), RenderError> {
        let fresh = LightState {
            index,
            ..LightState::default()
        };
        let states = vec![fresh; threads as usize];
        Ok(self.paths.write(bytemuck::cast_slice(&states))?)
    }

    /// The splats of the last dispatch in memory order: slot i of every thread before slot i + 1 of any.
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

/// The push constants for some sample indices of a tile.
pub fn slice(tile: Tile, film: &LightFilm<f32>, indices: &Range<u32>, budget: u32) -> LightSlice {
    let window = film.window();
    LightSlice {
        tile_x: tile.x,
        tile_y: tile.y,
        tile_width: tile.width,
        tile_height: tile.height,
        film_x: window.x,
        film_y: window.y,
        film_width: window.width,
        film_height: window.height,
        sample_begin: indices.start,
        sample_end: indices.end,
        budget,
        ..LightSlice::default()
    }
}

/// The counters of each thread in the last dispatch; added to the film.
pub fn read_lanes(
    buffer: &Buffer,
    threads: u32,
    film: &mut LightFilm<f32>,
) -> Result<Vec<LightLane>, RenderError> {
    let mut lanes = vec![LightLane::default(); threads as usize];
    buffer.read_into(bytemuck::cast_slice_mut(&mut lanes))?;
    let loops: u64 = lanes.iter().map(|lane| u64::from(lane.loops)).sum();
    if loops > 0 {
        return Err(RenderError::Loops(loops));
    }
    for lane in &lanes {
        film.count(LightCounts {
            rays: u64::from(lane.rays),
            long_paths: u64::from(lane.long_paths),
            underflows: u64::from(lane.underflows),
            nan: u64::from(lane.nan),
            infinite: u64::from(lane.infinite),
        });
    }
    Ok(lanes)
}

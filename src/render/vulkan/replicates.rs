//! Renderings by several seeds on one device: one kernel, one scene in its memory, the films on the host.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::develop;
use super::limits::DispatchLimits;
use super::run::Run;
use super::tile_film::TileFilm;
use crate::film::Film;
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::render::replicates::{Growing, Took};
use crate::render::slices::Slices;
use crate::render::{Job, RenderError};

/// A kernel that has been through its first dispatch, and the films so far.
pub struct Replicates<'a> {
    job: &'a Job<'a>,
    run: Run<'a>,
    slices: Slices,
    films: Vec<Replicate>,
    compile_s: f64,
}

struct Replicate {
    seed: u32,
    done: u32,
    /// Empty while the run has them.
    tiles: Vec<TileFilm>,
}

impl<'a> Replicates<'a> {
    pub fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        limits: DispatchLimits,
        seeds: &[u32],
    ) -> Result<Self, RenderError> {
        let features = job.features();
        let mut run = Run::new(job, device, &features, limits, Recording::Nothing)?;
        let compile_s = run.compile()?.as_secs_f64();
        let moments = features.keeps_moments();
        let film = |&seed: &u32| Replicate {
            seed,
            done: 0,
            tiles: run
                .tiles
                .iter()
                .map(|t| TileFilm::new(t.tile, moments))
                .collect(),
        };
        Ok(Self {
            films: seeds.iter().map(film).collect(),
            job,
            run,
            slices: Slices::new(),
            compile_s,
        })
    }

    /// Slices of samples from `done` to `spp`; returns how many there are.
    fn sample(&mut self, mut done: u32, spp: u32, stop: &AtomicBool) -> Result<u32, RenderError> {
        while done < spp && !stop.load(Ordering::Relaxed) {
            let slice = self.slices.next(spp - done);
            let mut longest = Duration::ZERO;
            for tile in 0..self.run.tiles.len() {
                longest = longest.max(self.run.advance(tile, done + slice)?);
            }
            self.slices.took(slice, longest);
            done += slice;
        }
        Ok(done)
    }
}

impl Growing for Replicates<'_> {
    fn advance(&mut self, i: usize, spp: u32, stop: &AtomicBool) -> Result<Took, RenderError> {
        let Replicate { seed, done, .. } = self.films[i];
        let tiles = std::mem::take(&mut self.films[i].tiles);
        let idle = self.run.exchange(tiles, seed)?;
        let (start, gpu) = (Instant::now(), self.run.gpu_time);
        let now = self.sample(done, spp, stop)?;
        let took = Took {
            wall_s: start.elapsed().as_secs_f64(),
            gpu_s: Some((self.run.gpu_time - gpu).as_secs_f64()),
        };
        self.films[i].done = now;
        self.films[i].tiles = std::mem::replace(&mut self.run.tiles, idle);
        Ok(took)
    }

    fn done(&self, i: usize) -> u32 {
        self.films[i].done
    }

    fn picture(&self, i: usize) -> Film {
        let Replicate { tiles, done, .. } = &self.films[i];
        develop::picture(tiles, self.job.area(), *done)
    }

    fn set_up_s(&self) -> f64 {
        let s = self.run.set_up;
        s.hierarchy + s.compose + s.upload + s.pipeline + self.compile_s
    }
}

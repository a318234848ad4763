//! Renderings by several seeds by the reference: one world, a film each.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::Render;
use crate::part::{AnyPart, Scalar};
use crate::reference::world::World;
use crate::render::replicates::{Growing, Took};
use crate::render::slices::Slices;
use crate::render::{DISPATCH_TIME, Job, RenderError, empty_part};

/// The world, and the films so far.
pub struct Replicates<'a, F, R> {
    job: &'a Job<'a>,
    world: World<F>,
    slices: Slices,
    films: Vec<Replicate<R>>,
    set_up_s: f64,
}

struct Replicate<R> {
    seed: u32,
    done: u32,
    film: R,
}

impl<'a, F: Scalar, R: Render<F>> Replicates<'a, F, R> {
    pub fn new(job: &'a Job<'a>, seeds: &[u32]) -> Self {
        let start = Instant::now();
        let film = |&seed: &u32| Replicate {
            seed,
            done: 0,
            film: R::new(job, empty_part(job, 0)),
        };
        Self {
            job,
            world: World::new(job.prepared),
            slices: Slices::new(DISPATCH_TIME),
            films: seeds.iter().map(film).collect(),
            set_up_s: start.elapsed().as_secs_f64(),
        }
    }
}

impl<F: Scalar, R: Render<F>> Growing for Replicates<'_, F, R> {
    fn advance(&mut self, i: usize, spp: u32, stop: &AtomicBool) -> Result<Took, RenderError> {
        let Replicate { seed, done, film } = &mut self.films[i];
        let job = Job {
            seed: *seed,
            ..*self.job
        };
        let start = Instant::now();
        while *done < spp && !stop.load(Ordering::Relaxed) {
            let slice = self.slices.next(spp - *done);
            let began = Instant::now();
            film.advance(&job, &self.world, *done + slice);
            self.slices.took(slice, began.elapsed());
            *done += slice;
        }
        Ok(Took {
            wall_s: start.elapsed().as_secs_f64(),
            gpu_s: None,
        })
    }

    fn done(&self, i: usize) -> u32 {
        self.films[i].done
    }

    fn part(&self, i: usize) -> AnyPart {
        F::any(self.films[i].film.part())
    }

    fn set_up_s(&self) -> f64 {
        self.set_up_s
    }
}

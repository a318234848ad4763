//! Renderings with several seeds on one device: one kernel, one scene in its memory, the films on the host.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::limits::DispatchLimits;
use super::rendering::Rendering;
use crate::gpu::Device;
use crate::part::{AnyPart, Scalar};
use crate::render::replicates::{Growing, Took};
use crate::render::slices::Slices;
use crate::render::{HostFilm, Job, RenderError};

/// A kernel that has completed its first dispatch, and the films so far.
pub struct Replicates<R, F> {
    run: R,
    slices: Slices,
    films: Vec<Replicate<F>>,
    /// The replicate whose film the run has.
    current: Option<usize>,
    compile_s: f64,
}

struct Replicate<F> {
    seed: u32,
    done: u32,
    /// `None` while the run has it.
    film: Option<F>,
}

impl<'a, R: Rendering<'a>> Replicates<R, R::Film> {
    pub fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        limits: DispatchLimits,
        seeds: &[u32],
    ) -> Result<Self, RenderError> {
        let mut run = R::new(job, device, &job.features(), limits)?;
        let compile_s = run.compile()?.as_secs_f64();
        let film = |&seed: &u32| Replicate {
            seed,
            done: 0,
            film: Some(run.empty()),
        };
        Ok(Self {
            films: seeds.iter().map(film).collect(),
            run,
            current: None,
            slices: Slices::new(limits.dispatch_time),
            compile_s,
        })
    }

    /// Makes the run continue with the film of replicate `i`.
    fn take_up(&mut self, i: usize) -> Result<(), RenderError> {
        if self.current == Some(i) {
            return Ok(());
        }
        let film = self.films[i].film.take();
        let film = film.unwrap_or_else(|| self.run.empty());
        let before = self.run.exchange(film, self.films[i].seed)?;
        if let Some(previous) = self.current.replace(i) {
            self.films[previous].film = Some(before);
        }
        Ok(())
    }

    /// Renders slices of samples from `done` to `spp`; returns the index reached.
    fn sample(&mut self, mut done: u32, spp: u32, stop: &AtomicBool) -> Result<u32, RenderError> {
        while done < spp && !stop.load(Ordering::Relaxed) {
            let slice = self.slices.next(spp - done);
            let longest: Duration = self.run.advance(done + slice, &mut |_| {})?;
            self.slices.took(slice, longest);
            done += slice;
        }
        Ok(done)
    }
}

impl<'a, R: Rendering<'a>> Growing for Replicates<R, R::Film> {
    fn advance(&mut self, i: usize, spp: u32, stop: &AtomicBool) -> Result<Took, RenderError> {
        self.take_up(i)?;
        let done = self.films[i].done;
        let (start, gpu) = (Instant::now(), self.run.costs().gpu_time);
        let now = self.sample(done, spp, stop)?;
        let took = Took {
            wall_s: start.elapsed().as_secs_f64(),
            gpu_s: Some((self.run.costs().gpu_time - gpu).as_secs_f64()),
        };
        self.films[i].done = now;
        Ok(took)
    }

    fn done(&self, i: usize) -> u32 {
        self.films[i].done
    }

    fn part(&self, i: usize) -> AnyPart {
        let film = self.films[i].film.as_ref();
        Scalar::any(film.unwrap_or_else(|| self.run.film()).part())
    }

    fn set_up_s(&self) -> f64 {
        let s = self.run.costs().set_up;
        s.hierarchy + s.compose + s.upload + s.pipeline + self.compile_s
    }
}

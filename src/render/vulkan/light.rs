//! Light paths on a device, alone or with eye paths: in tiles, their contributions added to the film by the host.

use std::ops::Range;
use std::time::{Duration, Instant};

use super::eye_paths::EyePaths;
use super::kernel::Kernel;
use super::light_paths::{Arrived, LightPaths, slice};
use super::rendering::{Costs, Rendering};
use crate::features::Features;
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::part::Part;
use crate::render::plan::{EyePlan, LightPlan, StatePlan, thread_tiles};
use crate::render::tiles::Tile;
use crate::render::{DispatchLimits, Job, LightFilm, RenderError, empty_part};
use crate::settings::Integrator;

/// The most light paths of one pass over the picture, unless one sample index has more: their splats are stored until
/// they can be added in order.
const PASS: u64 = 1 << 20;

/// A scene's light tracer, its buffers, and the film.
pub struct LightRun<'a> {
    job: &'a Job<'a>,
    kernel: Kernel<'a>,
    light: LightPaths,
    /// Only for bidirectional paths.
    pub eye: Option<EyePaths>,
    /// Tiles of light paths: a path's number is a pixel's, independent of where its splats go.
    pub tiles: Vec<Tile>,
    film: LightFilm<f32>,
    /// Sample indices of a pass.
    pass: u32,
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
        Self::recording(job, device, features, limits, tiles, Recording::Nothing)
    }

    fn compile(&mut self) -> Result<Duration, RenderError> {
        let start = Instant::now();
        self.trace(0, 0..0, &mut |_| {}, &mut |_, _| {})?;
        self.kernel.costs.gpu_time = Duration::ZERO;
        Ok(start.elapsed())
    }

    fn go_on(&mut self, part: Part<f32>) -> Result<(), RenderError> {
        self.film = LightFilm::new(self.job, part);
        Ok(())
    }

    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let begin = self.film.done();
        let mut longest = Duration::ZERO;
        while self.film.done() < samples {
            let first = self.film.done();
            let end = first + self.pass.min(samples - first);
            let mut part = |tiles: f64| {
                let done = f64::from(first - begin) + tiles * f64::from(end - first);
                progress(done / f64::from(samples - begin));
            };
            match self.pass(first..end, &mut part) {
                Ok(time) => longest = longest.max(time),
                Err(error) => {
                    self.film.give_up_pass();
                    return Err(error);
                }
            }
        }
        Ok(longest)
    }

    fn film(&self) -> &Self::Film {
        &self.film
    }

    fn empty(&self) -> Self::Film {
        LightFilm::new(self.job, empty_part(self.job, 0))
    }

    fn exchange(&mut self, film: Self::Film, seed: u32) -> Result<Self::Film, RenderError> {
        self.kernel.scene.reseed(self.job.prepared, seed)?;
        Ok(std::mem::replace(&mut self.film, film))
    }

    fn costs(&self) -> &Costs {
        &self.kernel.costs
    }

    fn buffers(&self) -> Vec<(String, u64)> {
        let eye = self.eye.iter().flat_map(EyePaths::buffers);
        self.kernel
            .buffers(self.light.buffers().into_iter().chain(eye))
    }
}

impl<'a> LightRun<'a> {
    /// Paths of the pixels of `tiles`, which are recorded in addition to the film.
    pub fn recording(
        job: &'a Job<'a>,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
        tiles: Vec<Tile>,
        recording: Recording,
    ) -> Result<Self, RenderError> {
        let largest = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        let both = features.integrator == Integrator::Bidirectional;
        let (light, eye) = (LightPlan::new(largest), EyePlan::new(largest));
        let state = match both {
            true => StatePlan::Bidirectional(light, eye),
            false => StatePlan::Light(light),
        };
        let mut kernel = Kernel::new(
            job,
            device,
            features,
            recording,
            limits.plan(device),
            &state,
        )?;
        let light = LightPaths::new(device, &light, &mut kernel)?;
        let eye = both
            .then(|| EyePaths::new(device, &eye, &mut kernel))
            .transpose()?;
        let pass = (PASS / u64::from(job.whole().pixels())).max(1) as u32;
        Ok(Self {
            job,
            light,
            pass: match eye {
                Some(_) => pass.min(EyePlan::samples(largest)),
                None => pass,
            },
            eye,
            kernel,
            tiles,
            film: LightFilm::new(job, empty_part(job, 0)),
            budget: limits.budget.max(1),
        })
    }

    /// The light paths of all tiles and of some sample indices; their contributions are added in the order of (sample,
    /// light path, vertex), then those of eye paths, which no tile and no slice changes.
    fn pass(
        &mut self,
        indices: Range<u32>,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let mut longest = Duration::ZERO;
        let mut splats = vec![Vec::new(); indices.len()];
        let mut seen = splats.clone();
        for tile in 0..self.tiles.len() {
            let place = |a: &Arrived| (a.index - indices.start) as usize;
            let mut splat = |a: Arrived| splats[place(&a)].push(a.splat);
            let mut see = |a: Arrived, _| seen[place(&a)].push(a.splat);
            longest = longest.max(self.trace(tile, indices.clone(), &mut splat, &mut see)?);
            if let [only] = &mut splats[..] {
                only.drain(..).for_each(|splat| self.film.splat(splat));
            }
            progress((tile + 1) as f64 / self.tiles.len() as f64);
        }
        for (splats, seen) in splats.into_iter().zip(seen) {
            let both = splats.into_iter().chain(seen);
            both.for_each(|splat| self.film.splat(splat));
            self.film.end_sample();
        }
        self.film.end_pass();
        Ok(longest)
    }

    /// Follows the paths of a tile and of some sample indices to their ends; `splat` gets the contributions of light
    /// paths, `see` those of eye paths, with their signatures.
    pub fn trace(
        &mut self,
        tile: usize,
        indices: Range<u32>,
        splat: &mut impl FnMut(Arrived),
        see: &mut impl FnMut(Arrived, u32),
    ) -> Result<Duration, RenderError> {
        let Self {
            job,
            kernel,
            light,
            eye,
            film,
            ..
        } = self;
        let slice = slice(self.tiles[tile], film, &indices, self.budget);
        let kept = eye.iter().flat_map(EyePaths::kept);
        let kept: Vec<_> = kept.collect();
        let longest = light.trace(kernel, &kept, &slice, film, splat)?;
        match eye {
            None => Ok(longest),
            Some(eye) => Ok(longest.max(eye.trace(job, kernel, light, &slice, film, see)?)),
        }
    }
}

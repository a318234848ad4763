//! Rendering by the CPU reference, in f32 or f64.

mod light;
mod path;
mod replicates;

use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::course::Course;
use super::follow::{Grows, Watch, follow};
use super::replicates::Growing;
use super::several::Ranges;
use super::{
    DISPATCH_TIME, HostFilm, Job, LightFilm, NEAREST, Outcome, Pixels, RenderError, SetUp, Start,
    Stats, empty_part,
};
use crate::part::{AnyPart, Part, Scalar};
use crate::reference::world::World;
use crate::settings::Integrator;
use replicates::Replicates;

/// The film of one integrator, to which the reference adds samples on every core.
trait Render<F: Scalar>: HostFilm<Scalar = F> {
    /// Continues a part of the job's picture.
    fn new(job: &Job, part: Part<F>) -> Self;
    /// Brings every pixel to the sample of index `samples`.
    fn advance(&mut self, job: &Job, world: &World<F>, samples: u32);
}

/// Renders with every core; the picture depends neither on their number nor on the slices of samples.
///
/// # Errors
/// [`RenderError::Start`] if it is to continue another job's samples.
pub fn render<F: Scalar>(
    job: &Job,
    name: &str,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    match job.settings.estimator.integrator {
        Integrator::Path => render_by::<F, Pixels<F>>(job, name, start, stop, watch),
        Integrator::Light | Integrator::Bidirectional => {
            render_by::<F, LightFilm<F>>(job, name, start, stop, watch)
        }
    }
}

/// Runs `work` with a maker of parts of the job's picture, in f32.
pub fn with_ranges(
    job: &Job,
    work: &mut dyn FnMut(&mut dyn Ranges) -> Result<Stats, RenderError>,
) -> Result<Stats, RenderError> {
    let empty = empty_part(job, 0);
    match job.settings.estimator.integrator {
        Integrator::Path => work(&mut Run::<f32, Pixels<f32>>::new(job, "cpu-f32", empty)),
        Integrator::Light | Integrator::Bidirectional => {
            work(&mut Run::<f32, LightFilm<f32>>::new(job, "cpu-f32", empty))
        }
    }
}

/// Renderings by several seeds.
pub fn replicates<'a, F: Scalar>(job: &'a Job<'a>, seeds: &[u32]) -> Box<dyn Growing + 'a> {
    match job.settings.estimator.integrator {
        Integrator::Path => Box::new(Replicates::<F, Pixels<F>>::new(job, seeds)),
        Integrator::Light | Integrator::Bidirectional => {
            Box::new(Replicates::<F, LightFilm<F>>::new(job, seeds))
        }
    }
}

/// A film and its accumulator.
struct Run<'a, F, R> {
    job: &'a Job<'a>,
    world: World<F>,
    film: R,
    stats: Stats,
}

impl<'a, F: Scalar, R: Render<F>> Run<'a, F, R> {
    fn new(job: &'a Job<'a>, name: &str, part: Part<F>) -> Self {
        let began = Instant::now();
        let world = World::new(job.prepared);
        let set_up = SetUp {
            hierarchy: began.elapsed().as_secs_f64(),
            ..SetUp::default()
        };
        let stats = Stats {
            device: name.into(),
            driver: driver(),
            rounding: NEAREST.to_owned(),
            set_up,
            ..Stats::default()
        };
        Self {
            job,
            world,
            film: R::new(job, part),
            stats,
        }
    }
}

impl<R: Render<f32>> Ranges for Run<'_, f32, R> {
    fn make(&mut self, samples: Range<u32>) -> Result<Part<f32>, RenderError> {
        self.film = R::new(self.job, empty_part(self.job, samples.start));
        self.film.advance(self.job, &self.world, samples.end);
        Ok(self.film.part())
    }

    fn took(&self) -> Stats {
        self.stats.clone()
    }
}

impl<F: Scalar, R: Render<F>> Grows for Run<'_, F, R> {
    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        let began = Instant::now();
        self.film.advance(self.job, &self.world, samples);
        progress(1.0);
        Ok(began.elapsed())
    }

    fn part(&self) -> AnyPart {
        F::any(self.film.part())
    }

    fn stats(&self) -> Stats {
        self.stats.clone()
    }
}

fn render_by<F: Scalar, R: Render<F>>(
    job: &Job,
    name: &str,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    let mut run = Run::<F, R>::new(job, name, start.part(job)?);
    let mut course = Course::new(job, stop, start, DISPATCH_TIME);
    follow(&mut course, &mut run, watch)?;
    Ok(course.so_far(run.part(), run.stats()))
}

/// The reference's entry in the place of a driver's name.
pub fn driver() -> String {
    format!(
        "vkpt's reference on {} threads",
        rayon::current_num_threads()
    )
}

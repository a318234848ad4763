//! Rendering by the CPU reference, in f32 or f64.

mod light;
mod path;
mod replicates;

use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::course::Course;
use super::replicates::Growing;
use super::{HostFilm, Job, LightFilm, Outcome, Pixels, Progress, SetUp, Stats, standard_errors};
use crate::reference::math::Real;
use crate::reference::world::World;
use crate::settings::Integrator;
use replicates::Replicates;

/// The film of one integrator, which the reference adds samples to on every core.
trait Render<F>: HostFilm {
    /// No samples yet.
    fn new(job: &Job) -> Self;
    /// Adds the samples to every pixel, those before them being there.
    fn advance(&mut self, job: &Job, world: &World<F>, samples: Range<u32>);
}

/// Renders with every core; the picture depends neither on their number nor on the slices of samples.
pub fn render<F: Real>(
    job: &Job,
    name: &str,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Outcome {
    match job.settings.estimator.integrator {
        Integrator::Path => render_by::<F, Pixels<F>>(job, name, stop, progress),
        Integrator::Light | Integrator::Bidirectional => {
            render_by::<F, LightFilm<F>>(job, name, stop, progress)
        }
    }
}

/// Renderings by several seeds.
pub fn replicates<'a, F: Real>(job: &'a Job<'a>, seeds: &[u32]) -> Box<dyn Growing + 'a> {
    match job.settings.estimator.integrator {
        Integrator::Path => Box::new(Replicates::<F, Pixels<F>>::new(job, seeds)),
        Integrator::Light | Integrator::Bidirectional => {
            Box::new(Replicates::<F, LightFilm<F>>::new(job, seeds))
        }
    }
}

fn render_by<F: Real, R: Render<F>>(
    job: &Job,
    name: &str,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Outcome {
    let start = Instant::now();
    let world = World::<F>::new(job.prepared);
    let set_up = SetUp {
        hierarchy: start.elapsed().as_secs_f64(),
        ..SetUp::default()
    };
    let mut film = R::new(job);
    let mut course = Course::new(job, stop);
    while let Some(samples) = course.next_slice() {
        let began = Instant::now();
        film.advance(job, &world, course.done()..samples);
        progress(course.progress(samples, 1.0));
        course.reached(samples, began.elapsed(), || film.halves(samples));
    }
    let (done, render_s) = (course.done(), course.seconds());
    let (end, errors) = course.finish();
    let counts = film.counts();
    let stats = Stats {
        device: name.into(),
        driver: driver(),
        set_up,
        render_s,
        samples: u64::from(done) * u64::from(job.area().pixels()),
        rays: counts.rays,
        dropped: counts.dropped,
        long_paths: counts.long_paths,
        underflows: counts.underflows,
        largest: film.largest(),
        ..Stats::default()
    };
    Outcome {
        film: film.picture(done),
        stderr: standard_errors(job, &film, done),
        spp: done,
        end,
        errors,
        stats,
    }
}

/// What stands where devices have a driver.
pub fn driver() -> String {
    format!(
        "vkpt's reference on {} threads",
        rayon::current_num_threads()
    )
}

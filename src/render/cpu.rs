//! Rendering by the CPU reference, in f32 or f64.

mod replicates;

use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use rayon::prelude::*;

use super::course::{Course, Halves};
use super::tiles::Tile;
use super::{Dropped, Job, Outcome, Progress, SetUp, Stats};
use crate::film::{Aov, Film};
use crate::reference::film::{
    FilmMoments, FilmPixel, film_half_difference, film_mean, film_moments, film_sample, film_stderr,
};
use crate::reference::integrator::path::record::Silent;
use crate::reference::integrator::path::trace_path;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::SampleId;
use crate::reference::world::World;
pub use replicates::Replicates;

/// Renders with every core; the picture depends neither on their number nor on the slices of samples.
pub fn render<F: Real>(
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
    let mut film = Pixels::<F>::new(job);
    let mut course = Course::new(job, stop);
    while let Some(samples) = course.next_slice() {
        let began = Instant::now();
        film.advance(job, &world, course.done()..samples);
        progress(course.progress(samples, 1.0));
        course.reached(samples, began.elapsed(), || film.halves(samples));
    }
    let (done, render_s) = (course.done(), course.seconds());
    let (end, errors) = course.finish();
    let stats = Stats {
        device: name.into(),
        driver: driver(),
        set_up,
        compile_s: 0.0,
        render_s,
        gpu_s: None,
        samples: u64::from(done) * u64::from(film.area.pixels()),
        rays: film.count(|p| p.rays),
        dropped: Dropped {
            nan: film.count(|p| p.nan),
            infinite: film.count(|p| p.infinite),
            loops: 0,
        },
        long_paths: film.count(|p| p.long_paths),
        underflows: film.count(|p| p.underflows),
        features: Vec::new(),
        spirv_bytes: 0,
        buffers: Vec::new(),
    };
    Outcome {
        film: film.picture(done),
        stderr: film.standard_errors(done),
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

/// The pixels under way, row by row.
struct Pixels<F> {
    area: Tile,
    film: Vec<FilmPixel<F>>,
    /// Where standard errors are asked for.
    moments: Option<Vec<FilmMoments<F>>>,
}

impl<F: Real> Pixels<F> {
    /// No samples yet.
    fn new(job: &Job) -> Self {
        let area = job.area();
        let pixels = area.pixels() as usize;
        let stderr = job.aovs.contains(&Aov::Stderr);
        Self {
            area,
            film: vec![FilmPixel::default(); pixels],
            moments: stderr.then(|| vec![FilmMoments::default(); pixels]),
        }
    }

    /// Adds the samples to every pixel.
    fn advance(&mut self, job: &Job, world: &World<F>, samples: Range<u32>) {
        let area = self.area;
        let advance = |i: usize, pixel: &mut _, mut moments: Option<&mut _>| {
            let i = i as u32;
            let at = [area.x + i % area.width, area.y + i / area.width];
            for sample in samples.clone() {
                sample_pixel(job, world, at, sample, pixel, moments.as_deref_mut());
            }
        };
        let film = self.film.par_iter_mut().enumerate();
        match &mut self.moments {
            None => film.for_each(|(i, pixel)| advance(i, pixel, None)),
            Some(moments) => film
                .zip(moments)
                .for_each(|((i, pixel), moments)| advance(i, pixel, Some(moments))),
        }
    }

    fn count(&self, of: fn(&FilmPixel<F>) -> u64) -> u64 {
        self.film.iter().map(of).sum()
    }

    /// The mean of `spp` samples a pixel.
    fn picture(&self, spp: u32) -> Film {
        self.develop(self.film.iter().map(|p| film_mean(p.sum, spp)))
    }

    /// That mean, with half the difference of its two groups of samples; `spp` ≥ 2.
    fn halves(&self, spp: u32) -> Halves {
        let half = |p: &FilmPixel<F>| film_half_difference(p.sum, p.contrast, spp);
        Halves {
            mean: self.picture(spp),
            half_difference: self.develop(self.film.iter().map(half)),
        }
    }

    /// Of that mean, where it was asked for and one sample is not all there is.
    fn standard_errors(&self, spp: u32) -> Option<Film> {
        let moments = self.moments.as_ref().filter(|_| spp >= 2)?;
        Some(self.develop(moments.iter().map(|m| film_stderr(m, spp))))
    }

    fn develop(&self, values: impl Iterator<Item = Vec3<F>>) -> Film {
        Film {
            width: self.area.width,
            height: self.area.height,
            rgb: values.map(|v| v.f64().as_vec3().to_array()).collect(),
        }
    }
}

/// Adds one sample to the pixel at column and row `at`.
fn sample_pixel<F: Real>(
    job: &Job,
    world: &World<F>,
    [column, row]: [u32; 2],
    sample: u32,
    pixel: &mut FilmPixel<F>,
    moments: Option<&mut FilmMoments<F>>,
) {
    let id = SampleId {
        column,
        row,
        pixel: row * world.width + column,
        sample,
        seed: job.seed,
    };
    let path = trace_path(world, &job.settings, id, &mut Silent);
    film_sample(pixel, path.radiance);
    if let Some(moments) = moments {
        film_moments(moments, path.radiance, sample + 1);
    }
    pixel.rays += path.rays;
    pixel.long_paths += u64::from(path.long);
    pixel.underflows += u64::from(path.underflow);
}

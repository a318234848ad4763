//! Rendering by the CPU reference, in f32 or f64.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use rayon::prelude::*;

use super::slices::Slices;
use super::tiles::Tile;
use super::{Dropped, Job, Outcome, Progress, Stats};
use crate::film::Film;
use crate::reference::film::{FilmPixel, film_mean, film_sample};
use crate::reference::math::Real;
use crate::reference::path::record::Silent;
use crate::reference::path::{SampleId, trace_path};
use crate::reference::world::World;

/// Renders with every core; the picture depends neither on their number nor on the slices of samples.
pub fn render<F: Real>(
    job: &Job,
    name: &str,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Outcome {
    let start = Instant::now();
    let world = World::<F>::new(job.prepared);
    let compose_s = start.elapsed().as_secs_f64();
    let area = job.area();
    let mut film = vec![FilmPixel::<F>::default(); area.pixels() as usize];
    let (mut done, mut slices) = (0, Slices::new());
    let start = Instant::now();
    while done < job.spp && !stop.load(Ordering::Relaxed) {
        let slice = slices.next(job.spp - done);
        let began = Instant::now();
        film.par_iter_mut().enumerate().for_each(|(i, pixel)| {
            let (column, row) = (
                area.x + i as u32 % area.width,
                area.y + i as u32 / area.width,
            );
            for sample in done..done + slice {
                sample_pixel(job, &world, column, row, sample as u32, pixel);
            }
        });
        slices.took(slice, began.elapsed());
        done += slice;
        progress(Progress::new(done, job.spp));
    }
    let count = |f: fn(&FilmPixel<F>) -> u64| film.iter().map(f).sum::<u64>();
    let stats = Stats {
        device: name.into(),
        driver: format!(
            "vkpt's reference on {} threads",
            rayon::current_num_threads()
        ),
        compose_s,
        compile_s: 0.0,
        render_s: start.elapsed().as_secs_f64(),
        gpu_s: None,
        samples: done * u64::from(area.pixels()),
        rays: count(|p| p.rays),
        dropped: Dropped {
            nan: count(|p| p.nan),
            infinite: count(|p| p.infinite),
            loops: 0,
        },
        long_paths: count(|p| p.long_paths),
        features: Vec::new(),
    };
    Outcome {
        film: develop(area, &film, done),
        spp: done,
        interrupted: done < job.spp,
        stats,
    }
}

fn sample_pixel<F: Real>(
    job: &Job,
    world: &World<F>,
    column: u32,
    row: u32,
    sample: u32,
    pixel: &mut FilmPixel<F>,
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
    pixel.rays += path.rays;
    pixel.long_paths += u64::from(path.long);
}

fn develop<F: Real>(area: Tile, film: &[FilmPixel<F>], spp: u64) -> Film {
    Film {
        width: area.width,
        height: area.height,
        rgb: film
            .iter()
            .map(|p| film_mean(p.sum, spp as u32).f64().as_vec3().to_array())
            .collect(),
    }
}

//! The picture by classes of paths: the contribution of each class to a pixel's mean.
//!
//! The reference follows the picture's own samples again, in f32, with the same random numbers, so that classes that
//! contain every path once add up to the picture; kernels have no code for it. Each class has its own sums, in f64.

mod both_paths;
mod eye_path;
mod film;
mod sample;
mod shares;
mod surface;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::slices::Slices;
use super::{DISPATCH_TIME, Job, Progress};
use crate::film::Channel;
use crate::reference::world::World;
use crate::settings::Integrator;
use film::ClassFilm;
pub use film::PIXEL_BYTES;

/// The classes that `job` requests, for a picture of `spp` samples: three channels a class, named after it, with a
/// value a pixel of the job's area. `None` if `stop` is set before it is done.
pub fn light_classes(
    job: &Job,
    spp: u32,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Option<Vec<Channel>> {
    if job.classes.is_empty() {
        return Some(Vec::new());
    }
    let world = World::<f32>::new(job.prepared);
    let mut film = ClassFilm::new(job);
    let mut slices = Slices::new(DISPATCH_TIME);
    let mut done = 0;
    while done < spp {
        if stop.load(Ordering::Relaxed) {
            return None;
        }
        let slice = slices.next(spp - done);
        let began = Instant::now();
        let indices = done..done + slice;
        match job.settings.estimator.integrator {
            Integrator::Path => film.add_eye_paths(job, &world, indices),
            Integrator::Light | Integrator::Bidirectional => {
                indices.for_each(|index| film.add_both_paths(job, &world, index));
            }
        }
        slices.took(slice, began.elapsed());
        done += slice;
        progress(Progress {
            samples_done: done,
            spp,
            fraction: f64::from(done) / f64::from(spp),
        });
    }
    Some(film.channels(job, spp))
}

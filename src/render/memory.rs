//! The host memory of a rendering, without its scene.

use super::{Job, LightFilm, RenderError, classes};
use crate::film::{Aov, Keeps};
use crate::memory::free;
use crate::part::{BLOCK, PixelSums, Scalar};
use crate::reference::film::{FilmMoments, FilmPixel, FilmQuarters};
use crate::settings::Integrator;

/// An error if the films of a job in the scalar `F`, `times` of each, cannot fit.
pub fn check<F: Scalar>(job: &Job, times: usize) -> Result<(), RenderError> {
    let needed = bytes::<F>(job) * times as u64;
    match free() {
        Some(free) if needed > free.all => Err(RenderError::Memory {
            needed,
            free: free.all,
        }),
        _ => Ok(()),
    }
}

/// The bytes of the current film, of the nodes below it, and of the pictures made from it.
fn bytes<F: Scalar>(job: &Job) -> u64 {
    let film = match job.settings.estimator.integrator {
        Integrator::Path => size_of::<FilmPixel<F>>() as u64,
        Integrator::Light | Integrator::Bidirectional => LightFilm::<F>::PIXEL_BYTES,
    };
    let beside = match job.features().keeps() {
        Keeps::Nothing => 0,
        Keeps::Moments => size_of::<FilmMoments<F>>() as u64,
        Keeps::Quarters => size_of::<FilmQuarters<F>>() as u64,
    };
    // At most a node a level, if the number of samples is known.
    let levels = match job.spp {
        u32::MAX => 0,
        spp => (spp / BLOCK).checked_ilog2().map_or(0, |log| log + 1),
    };
    let sums = size_of::<PixelSums<F>>() as u64 + beside;
    let pictures = 1 + u64::from(job.aovs.contains(&Aov::Stderr));
    let picture = pictures * size_of::<[f32; 3]>() as u64;
    let classes = job.classes.len() as u64 * classes::PIXEL_BYTES;
    u64::from(job.area().pixels()) * (film + beside + u64::from(levels) * sums + picture + classes)
}

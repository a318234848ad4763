//! What a rendering takes of the host's memory, beside its scene.

use super::{Job, LightFilm, RenderError};
use crate::film::Aov;
use crate::memory::free;
use crate::reference::film::{FilmMoments, FilmPixel};
use crate::reference::math::Real;
use crate::settings::Integrator;

/// An error where the films of a job in the scalar `F`, `times` of each, cannot fit.
pub fn check<F: Real>(job: &Job, times: usize) -> Result<(), RenderError> {
    let needed = bytes::<F>(job) * times as u64;
    match free() {
        Some(free) if needed > free.all => Err(RenderError::Memory {
            needed,
            free: free.all,
        }),
        _ => Ok(()),
    }
}

/// The bytes of the film under way, and of the pictures that come of it.
fn bytes<F: Real>(job: &Job) -> u64 {
    let film = match job.settings.estimator.integrator {
        Integrator::Path => size_of::<FilmPixel<F>>() as u64,
        Integrator::Light | Integrator::Bidirectional => LightFilm::<F>::PIXEL_BYTES,
    };
    let moments = match job.features().keeps_moments() {
        true => size_of::<FilmMoments<F>>(),
        false => 0,
    };
    let pictures = 1 + usize::from(job.aovs.contains(&Aov::Stderr));
    let picture = pictures * size_of::<[f32; 3]>();
    u64::from(job.area().pixels()) * (film + (moments + picture) as u64)
}

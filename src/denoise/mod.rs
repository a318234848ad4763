//! Denoises pictures: the result is never the truth, but sometimes close to it.
//!
//! Pure functions of films, except that Open Image Denoise uses its library ([`crate::gpu::oidn`]).

mod features;
mod nlm;
mod oidn;
mod weights;

pub use features::Features;
pub use nlm::nlm;
pub use oidn::{Oidn, usual_places};

use crate::film::Film;
pub use crate::gpu::oidn::OidnError;

/// A noisy picture and the two independent halves of its samples.
#[derive(Clone, Copy, Debug)]
pub struct Noisy<'a> {
    pub mean: &'a Film,
    pub halves: [&'a Film; 2],
}

/// A denoising method.
pub enum Denoiser {
    Oidn(Oidn),
    /// vkpt's own: non-local means.
    Nlm,
}

impl Denoiser {
    /// The denoised picture, of the same size. `features` must belong to the same pixels, but come from other samples
    /// than `noisy`.
    ///
    /// # Errors
    /// Errors of Open Image Denoise.
    pub fn denoise(&self, noisy: &Noisy, features: &Features) -> Result<Film, OidnError> {
        match self {
            Self::Oidn(oidn) => oidn.denoise(noisy.mean, features),
            Self::Nlm => Ok(nlm(noisy.halves, features)),
        }
    }

    /// Its name and version.
    pub fn name(&self) -> String {
        match self {
            Self::Oidn(oidn) => format!("Open Image Denoise {}", oidn.version()),
            Self::Nlm => "non-local means".to_owned(),
        }
    }
}

//! Denoising the pictures of a variant before they are judged.

use std::path::Path;
use std::time::Instant;

use super::vary::Combination;
use crate::cli::denoise::{features, load};
use crate::cli::exit::Failure;
use vkpt::denoise::{Denoiser, Features, Noisy};
use vkpt::film::Film;
use vkpt::render::Job;

/// What makes the pictures of a variant.
pub struct Finisher {
    denoiser: Denoiser,
    features: Features,
    /// What the features took, which any denoised picture takes.
    features_s: f64,
}

/// Those of all variants; `None` where nothing is done to their pictures.
///
/// # Errors
/// A library that is not to be had.
pub fn finishers(
    combinations: &[Combination],
    jobs: &[Job],
    oidn: Option<&Path>,
) -> Result<Vec<Option<Finisher>>, Failure> {
    let finisher = |(combination, job): (&Combination, &Job)| {
        let finisher = |by| {
            let denoiser = load(oidn, by).map_err(Failure::Usage)?;
            let began = Instant::now();
            let features = features(job)
                .ok_or_else(|| Failure::Usage("the surfaces cannot be seen".to_owned()))?;
            Ok(Finisher {
                denoiser,
                features,
                features_s: began.elapsed().as_secs_f64(),
            })
        };
        combination.denoise.map(finisher).transpose()
    };
    combinations.iter().zip(jobs).map(finisher).collect()
}

impl Finisher {
    /// The denoised picture, and the seconds that it took with its features.
    ///
    /// # Errors
    /// What the denoiser says.
    pub fn finish(&self, picture: &Film, halves: [&Film; 2]) -> Result<(Film, f64), String> {
        let began = Instant::now();
        let noisy = Noisy {
            mean: picture,
            halves,
        };
        let film = self.denoiser.denoise(&noisy, &self.features);
        let film = film.map_err(|error| error.to_string())?;
        Ok((film, self.features_s + began.elapsed().as_secs_f64()))
    }
}

//! Denoising the pictures of a variant before they are judged.

use std::path::Path;
use std::time::Instant;

use super::vary::Combination;
use crate::cli::denoise::{features, load};
use crate::cli::exit::Failure;
use vkpt::denoise::{Denoiser, Features, Noisy};
use vkpt::film::Film;
use vkpt::render::Job;

/// The denoiser of a variant's pictures.
pub struct Finisher {
    denoiser: Denoiser,
    features: Features,
    /// Seconds that the features took; every denoised picture includes them.
    features_s: f64,
}

/// The finishers of all variants; `None` for those whose pictures stay as they are.
///
/// # Errors
/// If the library is not available.
pub fn finishers(
    combinations: &[Combination],
    jobs: &[Job],
    oidn: Option<&Path>,
) -> Result<Vec<Option<Finisher>>, Failure> {
    let finisher = |(combination, job): (&Combination, &Job)| {
        let finisher = |by| {
            let denoiser = load(oidn, by).map_err(Failure::Usage)?;
            let began = Instant::now();
            let features = features(job).ok_or_else(|| {
                Failure::Usage("the scene shows no surfaces to denoise by".to_owned())
            })?;
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
    /// The message of the denoiser.
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

//! Denoised pictures next to noisy ones.

mod arguments;
mod load;

use std::time::Instant;

pub use arguments::{By, DenoiseArguments};
pub use load::load;

use vkpt::denoise::{Denoiser, Features, Noisy};
use vkpt::film::{Aov, Film};
use vkpt::metrics::denoised::bound;
use vkpt::part::Half;
use vkpt::render::{Job, Outcome, layers};
use vkpt::report::Denoised;
use vkpt::settings::{Sampler, Settings};

/// The fewest samples of a picture that can be denoised: one for each quarter.
pub const LEAST: u32 = 4;

/// Settings under which quarters of the samples are independent.
pub fn quartered(mut settings: Settings) -> Settings {
    let sampler = &mut settings.estimator.sampler;
    if *sampler == Sampler::Sobol {
        *sampler = Sampler::SobolQuarters;
    }
    settings
}

/// The surface features of the pixels of `job`, from samples that its pictures do not use.
pub fn features(job: &Job) -> Option<Features> {
    let job = Job {
        aovs: &[Aov::AlbedoBehind, Aov::NormalBehind],
        seed: !job.seed,
        ..*job
    };
    // With as many samples as layers ever have.
    Features::new(&layers(&job, u32::MAX), job.size())
}

/// The denoised picture, and a bound of its error.
///
/// # Errors
/// The reason for failure, as a sentence.
pub fn denoised(
    denoiser: &Denoiser,
    job: &Job,
    outcome: &Outcome,
) -> Result<(Film, Denoised), String> {
    let start = Instant::now();
    let halves = outcome.state.part.quartered();
    let Some([first, second]) = halves else {
        return Err(format!(
            "a picture of fewer than {LEAST} samples per pixel cannot be denoised"
        ));
    };
    let features = features(job).ok_or("it shows no surfaces to denoise by")?;
    let whole = Noisy {
        mean: &outcome.film,
        halves: [&first.mean, &second.mean],
    };
    let film = denoiser
        .denoise(&whole, &features)
        .map_err(|e| e.to_string())?;
    let seconds = start.elapsed().as_secs_f64();
    let Half {
        mean,
        quarters: [a, b],
    } = &first;
    let half = Noisy {
        mean,
        halves: [a, b],
    };
    let half = denoiser
        .denoise(&half, &features)
        .map_err(|e| e.to_string())?;
    let [a, b] = &second.quarters;
    let bound = bound(&half, [a, b]).map_err(|e| e.to_string())?;
    let record = Denoised {
        by: denoiser.name(),
        seconds,
        half_spp: outcome.spp - outcome.spp / 2,
        half_rel_mse: bound.estimate,
        half_rel_mse_upper: bound.upper,
        files: Vec::new(),
    };
    Ok((film, record))
}

//! Denoised pictures beside noisy ones.

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

/// Samples that a picture needs to be denoised: one for each quarter.
pub const LEAST: u32 = 4;

/// Settings under which quarters of the samples are independent.
pub fn quartered(mut settings: Settings) -> Settings {
    let sampler = &mut settings.estimator.sampler;
    if *sampler == Sampler::Sobol {
        *sampler = Sampler::SobolQuarters;
    }
    settings
}

/// What surfaces show of the pixels of `job`, by samples that its pictures have not.
pub fn features(job: &Job) -> Option<Features> {
    let job = Job {
        aovs: &[Aov::AlbedoBehind, Aov::NormalBehind],
        seed: !job.seed,
        ..*job
    };
    // By as many samples as layers ever have.
    Features::new(&layers(&job, u32::MAX), job.size())
}

/// The denoised picture, and what is known of its error.
///
/// # Errors
/// Why there is none, as a sentence.
pub fn denoised(
    denoiser: &Denoiser,
    job: &Job,
    outcome: &Outcome,
) -> Result<(Film, Denoised), String> {
    let start = Instant::now();
    let halves = outcome.state.part.quartered();
    let Some([first, second]) = halves else {
        return Err(format!(
            "a picture of less than {LEAST} samples cannot be denoised"
        ));
    };
    let features = features(job).ok_or("its surfaces cannot be seen")?;
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

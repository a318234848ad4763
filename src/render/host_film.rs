//! What a rendering has on the host: whatever made it, it can be looked at and counted.

use super::course::Halves;
use super::{Dropped, Job};
use crate::film::{Aov, Film};
use crate::sample::{GROUPS, Largest};
use crate::settings::Sampler;

/// The film of a picture, or of its crop, between two slices of samples.
pub trait HostFilm {
    /// The mean of `spp` samples a pixel.
    fn picture(&self, spp: u32) -> Film;
    /// That mean, with half the difference of its two groups of samples; `spp` ≥ 2.
    fn halves(&self, spp: u32) -> Halves;
    /// The standard errors of that mean by the spread of its samples, which must be independent, where their moments are
    /// kept; `spp` ≥ 2.
    fn spread(&self, spp: u32) -> Option<Film>;
    fn counts(&self) -> Counts;
    /// The sample with the brightest channel; `None` where all are black.
    fn largest(&self) -> Option<Largest>;
}

/// The standard errors of the mean of `spp` samples a pixel, where they are asked for; one sample tells none.
///
/// Each is the root of an unbiased estimate of the variance of its pixel and channel: of independent samples by their spread,
/// of others, which are not independent within a group, by the two groups, which are ([`film_half_difference`]).
///
/// [`film_half_difference`]: crate::reference::film::film_half_difference
pub fn standard_errors(job: &Job, film: &impl HostFilm, spp: u32) -> Option<Film> {
    if spp < 2 || !job.aovs.contains(&Aov::Stderr) {
        return None;
    }
    let of_groups = || {
        let mut half = film.halves(spp).half_difference;
        for x in half.rgb.as_flattened_mut() {
            *x = x.abs();
        }
        half
    };
    Some(film.spread(spp).unwrap_or_else(of_groups))
}

/// Degrees of freedom of such a standard error.
pub fn freedom(sampler: Sampler, spp: u32) -> f64 {
    match sampler {
        Sampler::Random => f64::from(spp) - 1.0,
        Sampler::Sobol => f64::from(GROUPS) - 1.0,
    }
}

/// What was counted on the way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub rays: u64,
    pub long_paths: u64,
    pub underflows: u64,
    pub dropped: Dropped,
}

//! What a rendering has on the host: whatever made it, it can be looked at and counted.

use super::Dropped;
use super::course::Halves;
use crate::film::Film;
use crate::sample::Largest;

/// The film of a picture, or of its crop, between two slices of samples.
pub trait HostFilm {
    /// The mean of `spp` samples a pixel.
    fn picture(&self, spp: u32) -> Film;
    /// That mean, with half the difference of its two groups of samples; `spp` ≥ 2.
    fn halves(&self, spp: u32) -> Halves;
    /// Of that mean, where it was asked for and one sample is not all there is.
    fn standard_errors(&self, spp: u32) -> Option<Film>;
    fn counts(&self) -> Counts;
    /// The sample with the brightest channel; `None` where all are black.
    fn largest(&self) -> Option<Largest>;
}

/// What was counted on the way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub rays: u64,
    pub long_paths: u64,
    pub underflows: u64,
    pub dropped: Dropped,
}

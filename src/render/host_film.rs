//! The film on the host: for any device it is a part of a picture.

use super::Job;
use crate::film::{Aov, Film};
use crate::part::{AnyPart, Part, Scalar};

/// The film of a picture, or of its crop, between two slices of samples.
pub trait HostFilm {
    type Scalar: Scalar;

    /// All samples that every pixel has.
    fn part(&self) -> Part<Self::Scalar>;
}

/// A part of the picture of a job: no samples, the first is to have the index `begin`.
pub fn empty_part<F: Scalar>(job: &Job, begin: u32) -> Part<F> {
    Part::new(job.size(), job.features().keeps(), begin)
}

/// The standard errors of a picture, if they are requested; one sample has none.
pub fn standard_errors(job: &Job, part: &AnyPart) -> Option<Film> {
    let known = part.samples() >= 2 && job.aovs.contains(&Aov::Stderr);
    known.then(|| part.standard_errors())
}

//! The progress of an experiment.

/// Reported after each batch of samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    pub part: Part,
    /// Samples per pixel of the part's pictures, or their target at this step.
    pub spp: u32,
    /// Seconds of sampling spent on the part so far.
    pub spent_s: f64,
    /// The maximum, except that a first step may take longer.
    pub seconds: f64,
}

/// The current work. Numbers count from 1; the second of a pair is the total.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Both halves of the reference.
    Reference,
    Step {
        number: usize,
        /// The one that has just reached the step's samples.
        replicate: [usize; 2],
        /// The turn of variants within the replicate.
        variant: [usize; 2],
    },
}

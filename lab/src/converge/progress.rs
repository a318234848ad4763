//! How far an experiment is.

/// Told after each stretch of samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    pub part: Part,
    /// Samples per pixel that the part's pictures have, or are to have at this step.
    pub spp: u32,
    /// Seconds of sampling that the part took so far.
    pub spent_s: f64,
    /// The most that it may take, but for a first step that takes longer.
    pub seconds: f64,
}

/// What is rendered. All is counted from 1; of a pair, the second is how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Both halves of the reference.
    Reference,
    Step {
        number: usize,
        /// The one that was just brought to the step's samples.
        replicate: [usize; 2],
        /// The turn of variants within the replicate.
        variant: [usize; 2],
    },
}

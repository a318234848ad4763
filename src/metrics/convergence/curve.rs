//! The measurements of an experiment.

use super::figures::{Figures, Metric};
use crate::film::Film;
use crate::metrics::Trimmed;

/// The replicates of one variant at the same number of samples.
#[derive(Clone, Debug)]
pub struct Step {
    /// Samples per pixel.
    pub spp: u32,
    /// For each replicate, wall-clock seconds of all its samples so far.
    pub wall_s: Vec<f64>,
    /// The same by the device's own timestamps, if available.
    pub gpu_s: Option<Vec<f64>>,
    /// The errors of each replicate.
    pub figures: Vec<Figures>,
    /// The picture of the first replicate.
    pub picture: Film,
}

impl Step {
    /// The errors of all replicates.
    pub fn errors(&self, metric: Metric) -> Vec<Trimmed> {
        self.figures.iter().map(|f| *f.of(metric)).collect()
    }

    /// The same over all pixels.
    pub fn means(&self, metric: Metric) -> Vec<f64> {
        self.errors(metric).iter().map(|e| e.all).collect()
    }
}

/// A variant after 1, 2, 4, … samples per pixel.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Seconds from the prepared scene to the first sample, including compilation. Not included in any step.
    pub set_up_s: f64,
    pub steps: Vec<Step>,
    /// The pictures of all replicates at the last step.
    pub pictures: Vec<Film>,
}

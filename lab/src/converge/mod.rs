//! An experiment: independent replicates of one or several renderings after 1, 2, 4, … samples per pixel, each compared
//! with a reference. `metrics::convergence` defines the figures.

pub mod command;
mod halves;
mod progress;
pub mod report;
mod schedule;

pub use halves::{HALVES, Halves, halves};
pub use progress::{Part, Progress};
pub use schedule::{Finish, Measured, Plan, Variant, measure};

use vkpt::metrics::MetricsError;
use vkpt::render::RenderError;

/// Why no curve could be measured.
#[derive(Debug, thiserror::Error)]
pub enum ConvergeError {
    #[error(transparent)]
    Render(#[from] RenderError),
    #[error(transparent)]
    Metrics(#[from] MetricsError),
    /// A picture could not be finished.
    #[error("{0}")]
    Finish(String),
}

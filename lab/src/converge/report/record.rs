//! The experiment as a whole; its JSON is `--json`'s file, field by field.

use serde::Serialize;

use super::variant::VariantRecord;
use vkpt::metrics::convergence::Figures;

/// The request, the device, and the results.
#[derive(Clone, Debug, Serialize)]
pub struct Convergence {
    pub version: &'static str,
    /// The scene file's path as it was given.
    pub scene: String,
    /// Width and height of the full picture.
    pub size: [u32; 2],
    pub crop: Option<[u32; 4]>,
    /// Of the first replicate; the others use the next numbers.
    pub seed: u32,
    pub replicates: usize,
    /// The maximum seconds of sampling, of all replicates and variants together, as requested.
    pub seconds: f64,
    /// Seconds of sampling spent: less, if another step would not have fitted.
    pub spent_s: f64,
    pub device: String,
    pub driver: String,
    /// How often an interval contains the truth.
    pub level: f64,
    /// Settings of the model differ: the variants converge to different pictures.
    pub models_differ: bool,
    /// Each variant is judged by a reference of its own model; else one picture judges all.
    pub own_references: bool,
    /// By ctrl-c.
    pub interrupted: bool,
    /// The others are compared with the first.
    pub variants: Vec<VariantRecord>,
}

/// A reference.
#[derive(Clone, Debug, Serialize)]
pub struct ReferenceRecord {
    /// A file, or the two halves that vkpt rendered.
    pub name: String,
    /// Its own error, if known.
    pub own: Figures<Option<f64>>,
}

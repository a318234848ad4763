//! The experiment as a whole; its JSON is `--json`'s file, field by field.

use serde::Serialize;

use super::variant::VariantRecord;
use vkpt::metrics::convergence::Figures;

/// What was asked, where it ran, what came out.
#[derive(Clone, Debug, Serialize)]
pub struct Convergence {
    pub version: &'static str,
    /// The scene file's path as it was given.
    pub scene: String,
    /// Width and height of the full picture.
    pub size: [u32; 2],
    pub crop: Option<[u32; 4]>,
    /// Of the first replicate; the others have those that follow.
    pub seed: u32,
    pub replicates: usize,
    /// The most seconds of sampling, of all replicates and variants together, as asked for.
    pub seconds: f64,
    /// Seconds of sampling that were spent: less, where another step would not have fitted.
    pub spent_s: f64,
    pub device: String,
    pub driver: String,
    /// How often an interval holds the truth.
    pub level: f64,
    /// Settings of the model differ: the variants converge to different pictures.
    pub models_differ: bool,
    /// Each variant is judged by a reference of its own model; else one picture judges all.
    pub own_references: bool,
    /// By ctrl-c.
    pub interrupted: bool,
    /// The first is what the others are compared with.
    pub variants: Vec<VariantRecord>,
}

/// What pictures were judged by.
#[derive(Clone, Debug, Serialize)]
pub struct ReferenceRecord {
    /// A file, or what vkpt made itself.
    pub name: String,
    /// How far it is from the truth itself, where that is known.
    pub own: Figures<Option<f64>>,
}

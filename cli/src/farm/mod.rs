//! A rendering in parts on many machines: the samples of each part, and the scripts that render and merge them.

pub mod command;
mod shares;
mod slurm;

pub use shares::{Share, rounds, shares};
pub use slurm::{Script, slurm};

/// The rendering and its files. Paths are absolute.
#[derive(Clone, Debug)]
pub struct Farm {
    /// The name of the jobs.
    pub name: String,
    /// The folder of scripts, parts and logs.
    pub folder: String,
    /// The program.
    pub vkpt: String,
    /// The scene and the flags of a rendering.
    pub rendering: Vec<String>,
    /// Files to write at the end.
    pub pictures: Vec<String>,
    pub partition: Option<String>,
    /// The parts, round by round.
    pub rounds: Vec<Vec<Share>>,
    /// No further round once the relMSE is below this, with 95 % confidence.
    pub target_error: Option<f64>,
    /// No further round that would end more than this many seconds after the first part started.
    pub seconds: Option<f64>,
}

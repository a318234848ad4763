//! A rendering in parts on many machines: which samples each part has, and the scripts that render and merge them.

pub mod command;
mod shares;
mod slurm;

pub use shares::{Share, rounds, shares};
pub use slurm::{Script, slurm};

/// What is to be rendered, and where. Paths are absolute.
#[derive(Clone, Debug)]
pub struct Farm {
    /// What jobs are called.
    pub name: String,
    /// Where scripts, parts and logs are.
    pub folder: String,
    /// The program.
    pub vkpt: String,
    /// The scene and the flags of a rendering.
    pub rendering: Vec<String>,
    /// Files to write in the end.
    pub pictures: Vec<String>,
    pub partition: Option<String>,
    /// The parts, round by round.
    pub rounds: Vec<Vec<Share>>,
    /// No further round once the relMSE is below this, with 95 % confidence.
    pub target_error: Option<f64>,
    /// No further round that would end later than so many seconds after the first part began.
    pub seconds: Option<f64>,
}

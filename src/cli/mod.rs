//! The command line: a file a command. Nothing below knows it, and nothing else prints.

mod arguments;
mod beside;
mod check;
mod command;
mod compare;
mod console;
mod converge;
mod denoise;
mod destination;
mod devices;
mod doctor;
mod exit;
mod explain;
mod export;
mod farm;
mod identity;
mod inputs;
mod integrator;
mod interrupt;
mod job;
mod keep;
mod limits;
mod listing;
mod memory;
mod merge;

mod numbers;
mod outputs;
mod progress;
mod render;
mod settings;
mod source;
mod stderr;
mod streams;
mod test;
mod values;
mod view;
mod writable;

pub use arguments::{Arguments, Task, help, task};
pub use check::{CheckArguments, check};
pub use compare::{CompareArguments, compare};
pub use converge::{ConvergeArguments, converge};
pub use devices::devices;
pub use doctor::{DoctorArguments, doctor};
pub use exit::{Ending, Failure, exit};
pub use explain::{ExplainArguments, explain};
pub use export::{ExportArguments, export};
pub use farm::{FarmArguments, farm};
pub use limits::meet_limits;
pub use merge::{MergeArguments, merge};

pub use render::{RenderArguments, render};
pub use settings::SettingArguments;
pub use test::{TestArguments, test};

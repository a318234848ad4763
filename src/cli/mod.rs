//! The command line: a file a command. Nothing below knows it, and nothing else prints.

mod arguments;
mod check;
mod command;
mod compare;
mod converge;
mod devices;
mod doctor;
mod exit;
mod explain;
mod interrupt;
mod job;
mod outputs;
mod progress;
mod record;
mod render;
mod reports;
mod settings;
mod trace;
mod values;
mod view;

pub use arguments::{Arguments, RenderArguments, Task, task};
pub use check::{CheckArguments, check};
pub use compare::{CompareArguments, compare};
pub use converge::{ConvergeArguments, converge};
pub use devices::devices;
pub use doctor::{DoctorArguments, doctor};
pub use exit::{Ending, Failure, exit};
pub use explain::{ExplainArguments, explain};
pub use render::render;
pub use settings::SettingArguments;
pub use trace::trace;

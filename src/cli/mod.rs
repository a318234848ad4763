//! The command line: a file a command. Nothing below knows it, and nothing else prints.

mod arguments;
mod check;
mod command;
mod compare;
mod console;
mod converge;
mod destination;
mod devices;
mod doctor;
mod exit;
mod explain;
mod export;
mod integrator;
mod interrupt;
mod job;
mod memory;
mod progress;
mod render;
mod settings;
mod source;
mod stderr;
mod streams;
mod values;
mod view;

pub use arguments::{Arguments, Task, task};
pub use check::{CheckArguments, check};
pub use compare::{CompareArguments, compare};
pub use converge::{ConvergeArguments, converge};
pub use devices::devices;
pub use doctor::{DoctorArguments, doctor};
pub use exit::{Ending, Failure, exit};
pub use explain::{ExplainArguments, explain};
pub use export::{ExportArguments, export};
pub use render::{RenderArguments, render};
pub use settings::SettingArguments;

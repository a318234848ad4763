//! The program `vkpt`: its commands, a file or folder each, and each command as another program calls it.

mod arguments;
mod devices;
pub mod export;
pub mod farm;
mod init;
mod keep;
mod limits;
pub mod live;
mod merge;
mod outputs;
mod render;
mod run;

pub use arguments::{Arguments, command_line, flags, parsed};
pub use limits::meet_limits;
pub use render::{Growing, RenderArguments, Rendered, rendered};
pub use run::run;

//! The files of a rendering, and writing them.

mod arguments;
mod files;
mod pictures;
mod write;

pub use arguments::OutputArguments;
pub use files::{Outputs, is_part};
pub use write::{Written, notes, write};

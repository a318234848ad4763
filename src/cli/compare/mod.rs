//! `vkpt compare`.

mod arguments;
mod paired;

use super::exit::{Ending, Failure};
pub use arguments::CompareArguments;
use paired::paired;

/// Compares what the command line names.
pub fn compare(arguments: &CompareArguments) -> Result<Ending, Failure> {
    paired(&arguments.paired)
}

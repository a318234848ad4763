//! `vkpt compare`.

mod arguments;
mod known;
mod paired;
mod pictures;

use super::exit::{Ending, Failure};
pub use arguments::CompareArguments;
use paired::paired;
use pictures::pictures;

/// Compares what the command line names.
pub fn compare(arguments: &CompareArguments) -> Result<Ending, Failure> {
    match arguments.pictures.a {
        Some(_) => pictures(&arguments.pictures),
        None => paired(&arguments.paired),
    }
}

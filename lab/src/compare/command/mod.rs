//! `vkpt compare`.

mod arguments;
mod call;
mod comparand;
mod known;
mod paired;
mod pictures;

use crate::cli::exit::{Ending, Failure};
pub use arguments::CompareArguments;
pub use call::compared;
pub use comparand::Comparand;
use paired::paired;
use pictures::pictures;

/// Compares the pictures or renderers that the command line names.
pub fn compare(arguments: &CompareArguments) -> Result<Ending, Failure> {
    match arguments.pictures.a {
        Some(_) => pictures(&arguments.pictures),
        None => paired(&arguments.paired),
    }
}

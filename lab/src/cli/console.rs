//! Text for people.

use super::destination::Destination;
use super::streams::{print_line, put};
use vkpt::image::file::FileError;

/// Where text for people goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Console {
    Stdout,
    /// If stdout carries other output.
    Stderr,
}

impl Console {
    /// Stdout, unless one of the files goes there.
    pub fn beside<'a>(files: impl IntoIterator<Item = &'a Destination>) -> Self {
        match files.into_iter().any(Destination::is_stdout) {
            true => Self::Stderr,
            false => Self::Stdout,
        }
    }

    /// Prints a text that ends with a line break.
    pub fn print(self, text: &str) -> Result<(), FileError> {
        match self {
            Self::Stdout => put(text.as_bytes()),
            Self::Stderr => {
                print_line(text.trim_end_matches('\n'));
                Ok(())
            }
        }
    }
}

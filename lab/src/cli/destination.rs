//! Where a command writes its outputs: to files, or for `-` to stdout.

use std::ffi::OsString;
use std::fmt;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};

use same_file::Handle;

use super::exit::Failure;
use super::identity;
use super::streams::Stream;
use vkpt::image::file::{FileError, Sink, write_whole};
use vkpt::image::place::Place;

/// The value of a flag that takes a FILE.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Destination {
    /// `-`
    Stdout,
    File(PathBuf),
}

impl From<OsString> for Destination {
    fn from(word: OsString) -> Self {
        match word.to_str() {
            Some("-") => Self::Stdout,
            _ => Self::File(word.into()),
        }
    }
}

impl fmt::Display for Destination {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Stdout => f.write_str("stdout"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

impl Destination {
    /// The path of the file; `None` for stdout.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
        }
    }

    /// The path of the file, if other files can be written next to it: not of a device, a pipe or stdout.
    pub fn neighbour(&self) -> Option<&Path> {
        let is_file = |path: &&Path| !matches!(Place::of(path), Ok(Place::Straight(_)));
        self.path().filter(is_file)
    }

    /// The stream that it is written to, if that is already open.
    pub fn stream(&self) -> Option<Stream> {
        match self {
            Self::Stdout => Some(Stream::Stdout),
            Self::File(path) => Stream::of(path),
        }
    }

    /// Whether it is stdout, under any name.
    pub fn is_stdout(&self) -> bool {
        self.stream() == Some(Stream::Stdout)
    }

    /// The identity of the file, if it exists.
    pub fn identity(&self) -> Option<Handle> {
        match self {
            Self::Stdout => identity::of_stdout(),
            Self::File(path) => identity::of(path),
        }
    }

    /// Writes the output of `fill`, all of it or, on an error, nothing.
    pub fn write<E>(&self, fill: impl FnOnce(&mut dyn Sink) -> Result<(), E>) -> Written
    where
        E: std::error::Error + Send + Sync + 'static,
    {
        let stream = match (self, self.stream()) {
            (Self::File(path), None) => return write_whole(path, fill),
            (_, stream) => stream.unwrap_or(Stream::Stdout),
        };
        let mut bytes = Cursor::new(Vec::new());
        fill(&mut bytes).map_err(|error| FileError {
            path: stream.name(),
            cause: io::Error::other(error),
        })?;
        stream.put(bytes.get_ref())
    }
}

/// Whether a file, or a text, was written.
pub type Written = Result<(), FileError>;

/// Writes a text, if requested.
pub fn whole(to: &Option<Destination>, text: impl FnOnce() -> io::Result<String>) -> Written {
    match to {
        Some(to) => to.write(|out| out.write_all(text()?.as_bytes())),
        None => Ok(()),
    }
}

/// A record as indented JSON that ends in a line break.
pub fn json(record: &impl serde::Serialize) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(record)? + "\n")
}

/// Collects everything that could not be written.
pub fn all_written(written: impl IntoIterator<Item = Written>) -> Result<(), Failure> {
    let errors: Vec<FileError> = written.into_iter().filter_map(Result::err).collect();
    match errors.is_empty() {
        true => Ok(()),
        false => Err(Failure::Files(errors)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_dash_alone_is_stdout() {
        let of = |word: &str| Destination::from(OsString::from(word));
        assert_eq!(of("-"), Destination::Stdout);
        for name in ["./-", "-.png", "--", "a"] {
            assert_eq!(of(name).path(), Some(Path::new(name)));
        }
    }
}

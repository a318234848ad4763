//! Where a command writes what it makes: to files, and for `-` to stdout.

use std::ffi::OsString;
use std::fmt;
use std::io::{self, Cursor, Seek, Write};
use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::streams::put;
use crate::image::file::{FileError, check_writable, write_whole};

/// What a flag that takes a FILE names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Destination {
    /// `-`
    Stdout,
    File(PathBuf),
}

/// What is written to: encoders of pictures go back to fill in sizes.
pub trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

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
    /// The file, if it is one.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
        }
    }

    /// Writes what `fill` writes, all of it or, on an error, nothing.
    pub fn write<E>(&self, fill: impl FnOnce(&mut dyn Sink) -> Result<(), E>) -> Written
    where
        E: std::error::Error + Send + Sync + 'static,
    {
        match self {
            Self::File(path) => write_whole(path, |out| fill(out)),
            Self::Stdout => {
                let mut bytes = Cursor::new(Vec::new());
                fill(&mut bytes).map_err(|error| FileError {
                    path: PathBuf::from("stdout"),
                    cause: io::Error::other(error),
                })?;
                put(bytes.get_ref())
            }
        }
    }

    /// Where it is, whatever name its folder has.
    fn place(&self) -> Self {
        let Self::File(path) = self else {
            return Self::Stdout;
        };
        let folder = match path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        match (folder.canonicalize(), path.file_name()) {
            (Ok(folder), Some(name)) => Self::File(folder.join(name)),
            _ => self.clone(),
        }
    }
}

/// Every file can be written, and no two go to one place. Found out before the work starts, and without a trace.
pub fn check<'a>(files: impl IntoIterator<Item = &'a Destination>) -> Result<(), Failure> {
    let files: Vec<&Destination> = files.into_iter().collect();
    all_written(
        files
            .iter()
            .filter_map(|file| file.path())
            .map(check_writable),
    )?;
    let places: Vec<Destination> = files.iter().map(|file| file.place()).collect();
    let twice = (1..files.len()).find(|&i| places[..i].contains(&places[i]));
    match twice.map(|i| files[i]) {
        None => Ok(()),
        Some(Destination::Stdout) => Err(Failure::Usage(
            "two outputs would be written to stdout: give one of them a name".to_owned(),
        )),
        Some(file) => Err(Failure::Usage(format!(
            "two outputs would be written to one file, {file}"
        ))),
    }
}

/// Whether a file, or a text, was written.
pub type Written = Result<(), FileError>;

/// Writes a text where it is asked for.
pub fn whole(to: &Option<Destination>, text: impl FnOnce() -> io::Result<String>) -> Written {
    match to {
        Some(to) => to.write(|out| out.write_all(text()?.as_bytes())),
        None => Ok(()),
    }
}

/// A record as JSON to read, ending in a line break.
pub fn json(record: &impl serde::Serialize) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(record)? + "\n")
}

/// Tells everything that could not be written.
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

    #[test]
    fn one_place_by_two_names_is_a_mistake_of_the_command_line() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| match name {
            "-" => Destination::Stdout,
            _ => Destination::File(folder.path().join(name)),
        };
        std::fs::create_dir(folder.path().join("in")).expect("a folder");
        let check = |names: [&str; 3]| check(&names.map(path));
        assert!(check(["a", "b", "-"]).is_ok());
        assert!(check(["a", "in/a", "in/b"]).is_ok());
        for same in [
            ["a", "b", "a"],
            ["a", "in/../a", "b"],
            ["./in/b", "-", "in/b"],
            ["-", "a", "-"],
        ] {
            assert!(matches!(check(same), Err(Failure::Usage(_))), "{same:?}");
        }
        let errors = check(["none/a", "in", "-"]);
        assert!(matches!(errors, Err(Failure::Files(told)) if told.len() == 2));
    }
}

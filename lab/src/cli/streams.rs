//! Stdout and stderr, without the panic of `println!` if the reader is gone.

use std::fmt::Display;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::identity;
use vkpt::image::file::FileError;
use vkpt::image::place::{Place, folder};
use vkpt::image::straight::unless_gone;

/// The standard streams for output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    Stdout,
    Stderr,
}

impl Stream {
    /// The stream that a file name means: by number, such as /dev/stdout and /dev/fd/1, or because the stream is redirected
    /// into that file.
    pub fn of(path: &Path) -> Option<Self> {
        match Place::of(path).ok()? {
            Place::Straight(path) if is_numbered(&path) => match path.file_name()?.to_str()? {
                "1" => Some(Self::Stdout),
                "2" => Some(Self::Stderr),
                _ => None,
            },
            Place::Straight(_) => None,
            Place::File(path) => match Some(identity::of(&path)?) {
                file if file == identity::of_stdout() => Some(Self::Stdout),
                file if file == identity::of_stderr() => Some(Self::Stderr),
                _ => None,
            },
        }
    }

    /// Writes to it.
    pub fn put(self, bytes: &[u8]) -> Result<(), FileError> {
        let mut out: Box<dyn Write> = match self {
            Self::Stdout => Box::new(io::stdout().lock()),
            Self::Stderr => Box::new(io::stderr().lock()),
        };
        self.written(out.write_all(bytes).and_then(|()| out.flush()))
    }

    fn written(self, written: io::Result<()>) -> Result<(), FileError> {
        unless_gone(written).map_err(|cause| FileError {
            path: self.name(),
            cause,
        })
    }

    /// Its name in messages.
    pub fn name(self) -> PathBuf {
        match self {
            Self::Stdout => "stdout".into(),
            Self::Stderr => "stderr".into(),
        }
    }
}

/// Whether the name denotes a file of this process by number.
fn is_numbered(path: &Path) -> bool {
    let numbers = Path::new("/dev/fd").canonicalize();
    numbers.is_ok_and(|numbers| folder(path).canonicalize().is_ok_and(|own| own == numbers))
}

/// Prints a line on stderr. If that fails, nothing can report it.
pub fn print_line(line: impl Display) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Writes to stdout.
pub fn put(bytes: &[u8]) -> Result<(), FileError> {
    Stream::Stdout.put(bytes)
}

/// Writes clap's help or version to stdout, in colour on a terminal.
pub fn print_help(text: &clap::Error) -> Result<(), FileError> {
    let printed = text.print().and_then(|()| io::stdout().flush());
    Stream::Stdout.written(printed)
}

//! Stdout and stderr, without the panic of `println!` where nobody reads them.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;

use crate::image::file::FileError;

/// Prints a line on stderr. Where that fails there is nowhere left to say so.
pub fn tell(line: impl Display) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Writes to stdout. A reader that has gone away has read enough, which is no error.
pub fn put(bytes: &[u8]) -> Result<(), FileError> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(cause) if cause.kind() != ErrorKind::BrokenPipe => Err(FileError {
            path: PathBuf::from("stdout"),
            cause,
        }),
        _ => Ok(()),
    }
}

//! Writing to what no file may take the place of: devices, pipes, and what somebody has opened.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Whether it can be written to.
pub(super) fn check(path: &Path) -> io::Result<()> {
    // Whoever reads a pipe would take a writer that goes away again for its end.
    match is_pipe(path) {
        true => Ok(()),
        false => open(path).map(drop),
    }
}

/// Writes all bytes to it.
pub(super) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    unless_gone(open(path)?.write_all(bytes))
}

/// What became of writing to a pipe: a reader that has gone away has read enough, which is no error.
pub fn unless_gone(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(cause) if cause.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// Opens it. A file that somebody else has opened may have something in it already.
fn open(path: &Path) -> io::Result<File> {
    let is_file = fs::metadata(path)?.is_file();
    OpenOptions::new().write(true).append(is_file).open(path)
}

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_: &Path) -> bool {
    false
}

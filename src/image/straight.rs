//! Writes to targets that must not be replaced: devices, pipes and open files of processes.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Checks that it can be written.
pub(super) fn check(path: &Path) -> io::Result<()> {
    match kind(path)? {
        // A reader of a pipe would take the end of a trial write for the end of the data.
        Kind::Pipe => Ok(()),
        Kind::Socket => Err(io::Error::other(
            "is a socket, which cannot be opened by name",
        )),
        Kind::Other => open(path).map(drop),
    }
}

/// Writes all bytes to it.
pub(super) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    unless_gone(open(path)?.write_all(bytes))
}

/// Ignores a broken pipe: a reader that has closed it has read enough.
pub fn unless_gone(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(cause) if cause.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// Opens it for writing. An open file of another process may already have content, so it is appended to.
fn open(path: &Path) -> io::Result<File> {
    let is_file = fs::metadata(path)?.is_file();
    OpenOptions::new().write(true).append(is_file).open(path)
}

#[cfg_attr(not(unix), expect(dead_code, reason = "only Unix has these kinds"))]
enum Kind {
    Pipe,
    Socket,
    Other,
}

#[cfg(unix)]
fn kind(path: &Path) -> io::Result<Kind> {
    use std::os::unix::fs::FileTypeExt;
    let kind = fs::metadata(path)?.file_type();
    Ok(match (kind.is_fifo(), kind.is_socket()) {
        (true, _) => Kind::Pipe,
        (_, true) => Kind::Socket,
        _ => Kind::Other,
    })
}

#[cfg(not(unix))]
fn kind(_: &Path) -> io::Result<Kind> {
    Ok(Kind::Other)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn sockets_are_refused_and_devices_tried() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("socket");
        let _socket = std::os::unix::net::UnixListener::bind(&path).expect("a socket");
        assert!(check(&path).is_err_and(|e| e.to_string().contains("is a socket")));
        assert!(check(Path::new("/dev/null")).is_ok());
    }
}

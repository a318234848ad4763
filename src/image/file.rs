//! Files that appear whole or not at all.

use std::fs::{self, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {cause}", path.display())]
pub struct FileError {
    pub path: PathBuf,
    pub cause: io::Error,
}

/// Where the standard errors of a picture stand: `NAME-stderr.exr` beside `NAME.png` or `NAME.exr`.
pub fn stderr_path(picture: &Path) -> PathBuf {
    let mut name = picture.file_stem().unwrap_or_default().to_os_string();
    name.push("-stderr.exr");
    picture.with_file_name(name)
}

/// Whether `path` can be written, found out before a rendering is spent on it. Leaves no trace.
pub fn check_writable(path: &Path) -> Result<(), FileError> {
    let check = || {
        if path.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder"));
        }
        if is_special(path) {
            return Ok(());
        }
        temporary(path).map(drop)
    };
    check().map_err(|cause| FileError {
        path: path.to_owned(),
        cause,
    })
}

/// Writes what `fill` writes: to a temporary name in the same folder, renamed once all of it is there. On an
/// error the temporary file is removed and what stood at `path` stays. Devices and pipes stay too: they are written to.
pub fn write_whole<E>(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<fs::File>) -> Result<(), E>,
) -> Result<(), FileError>
where
    E: std::error::Error + Send + Sync + 'static,
{
    let write = || {
        let special = is_special(path);
        let temporary = match special {
            true => NamedTempFile::new(),
            false => temporary(path),
        }?;
        let mut out = BufWriter::new(temporary.as_file().try_clone()?);
        fill(&mut out).map_err(io::Error::other)?;
        out.flush()?;
        if special {
            let mut place = fs::OpenOptions::new().write(true).open(path)?;
            io::copy(&mut temporary.reopen()?, &mut place)?;
        } else {
            temporary.persist(path)?;
        }
        Ok(())
    };
    write().map_err(|cause| FileError {
        path: path.to_owned(),
        cause,
    })
}

/// Whether a device or a pipe is there, such as /dev/null: no file may take its place.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir())
}

/// A file beside `path`, removed when dropped; it gets the permissions of any new file.
fn temporary(path: &Path) -> io::Result<NamedTempFile> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut builder = Builder::new();
    builder.prefix(".vkpt-");
    #[cfg(unix)]
    builder.permissions(<Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("folder").flatten();
        entries
            .map(|entry| entry.file_name().to_string_lossy().into_owned())
            .collect()
    }

    #[test]
    fn a_failure_leaves_what_was_there() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("a.png");
        fs::write(&path, "old").expect("old file");
        let failed = write_whole(&path, |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert_eq!(
            failed.expect_err("must fail").to_string(),
            format!("{}: no more", path.display())
        );
        assert_eq!(fs::read(&path).expect("old file"), b"old");
        assert_eq!(names(folder.path()), ["a.png"]);
    }

    #[test]
    fn a_success_replaces_it() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("a.png");
        fs::write(&path, "old").expect("old file");
        write_whole(&path, |out| out.write_all(b"new")).expect("written");
        assert_eq!(fs::read(&path).expect("new file"), b"new");
        assert_eq!(names(folder.path()), ["a.png"]);
    }

    /// A link stands for the device itself, which a failing test would cost the whole machine.
    #[cfg(unix)]
    #[test]
    fn a_device_stays_where_it_is() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("null.png");
        std::os::unix::fs::symlink("/dev/null", &path).expect("a link");
        check_writable(&path).expect("writable");
        write_whole(&path, |out| out.write_all(b"new")).expect("written");
        assert!(is_special(&path));
        assert_eq!(names(folder.path()), ["null.png"]);
    }

    #[test]
    fn a_check_leaves_nothing() {
        let folder = tempfile::tempdir().expect("folder");
        check_writable(&folder.path().join("a.png")).expect("writable");
        assert!(names(folder.path()).is_empty());
        assert!(check_writable(folder.path()).is_err());
        assert!(check_writable(&folder.path().join("none/a.png")).is_err());
    }
}

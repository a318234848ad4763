//! Writes files atomically: the complete file or nothing.

use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Cursor, ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::place::{Place, folder};
use super::straight;

/// The reason why a file could not be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {cause}", path.display())]
pub struct FileError {
    pub path: PathBuf,
    pub cause: io::Error,
}

/// The output of an encoder; picture encoders seek back to fill in sizes.
pub trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

/// The path of a picture's standard errors: `NAME-stderr.exr` for `NAME.png` or `NAME.exr`.
pub fn stderr_path(picture: &Path) -> PathBuf {
    let mut name = picture.file_stem().unwrap_or_default().to_os_string();
    name.push("-stderr.exr");
    picture.with_file_name(name)
}

/// `NAME-denoised.EXT` next to the picture `NAME.EXT`.
pub fn denoised_path(picture: &Path) -> PathBuf {
    let mut name = picture.file_stem().unwrap_or_default().to_os_string();
    name.push("-denoised");
    if let Some(extension) = picture.extension() {
        name.push(".");
        name.push(extension);
    }
    picture.with_file_name(name)
}

/// Checks before a rendering whether `path` can be written. Leaves no trace.
pub fn check_writable(path: &Path) -> Result<(), FileError> {
    let check = || match Place::of(path)? {
        Place::File(path) => {
            // A read-only file must not be replaced either, even if its folder would allow it.
            if path.exists() {
                OpenOptions::new().write(true).open(&path)?;
            }
            temporary(&path).map(drop)
        }
        Place::Straight(path) => straight::check(&path),
    };
    check().map_err(|cause| FileError {
        path: path.to_owned(),
        cause,
    })
}

/// Writes the output of `fill` to a temporary file in the same folder and renames it when it is complete. On an error
/// the temporary file is removed and the file at `path` stays. Links stay too: the file that they resolve to is
/// replaced. Devices and pipes are written directly.
pub fn write_whole<E>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Sink) -> Result<(), E>,
) -> Result<(), FileError>
where
    E: std::error::Error + Send + Sync + 'static,
{
    let write = || match Place::of(path)? {
        Place::File(path) => replace(&path, fill),
        Place::Straight(path) => {
            let mut bytes = Cursor::new(Vec::new());
            fill(&mut bytes).map_err(io::Error::other)?;
            straight::write(&path, bytes.get_ref())
        }
    };
    write().map_err(|cause| FileError {
        path: path.to_owned(),
        cause,
    })
}

/// Replaces the file at `path`, keeping its permissions.
fn replace<E>(path: &Path, fill: impl FnOnce(&mut dyn Sink) -> Result<(), E>) -> io::Result<()>
where
    E: std::error::Error + Send + Sync + 'static,
{
    let temporary = temporary(path)?;
    let mut out = BufWriter::new(temporary.as_file());
    fill(&mut out).map_err(io::Error::other)?;
    out.flush()?;
    drop(out);
    if let Ok(there) = fs::metadata(path) {
        // A file system without permissions must not cost the file.
        let _ = temporary.as_file().set_permissions(there.permissions());
    }
    // Otherwise the rename may reach the disk before the content, and a crash would lose both files.
    temporary.as_file().sync_data()?;
    temporary.persist(path)?;
    Ok(())
}

/// A file next to `path`, removed when dropped, with the permissions of any new file.
fn temporary(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".vkpt-");
    #[cfg(unix)]
    builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    let folder = folder(path);
    match folder.exists() {
        true => builder.tempfile_in(folder).map_err(nameless),
        false => Err(io::Error::new(
            ErrorKind::NotFound,
            "its folder does not exist; create it first",
        )),
    }
}

/// The cause without the temporary name that `tempfile` adds, which means nothing to the user. For a read-only folder
/// the cause is the folder.
fn nameless(error: io::Error) -> io::Error {
    let text = error.to_string();
    let cause = text
        .split_once(" at path ")
        .map_or(&*text, |(cause, _)| cause);
    let whose = match error.kind() {
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => "its folder: ",
        _ => "",
    };
    io::Error::new(error.kind(), format!("{whose}{cause}"))
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
    fn a_failure_leaves_the_old_file() {
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

    /// Uses a link to the device, because a failing test on the device itself would cost the whole machine.
    #[cfg(unix)]
    #[test]
    fn a_device_stays_where_it_is() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("null.png");
        std::os::unix::fs::symlink("/dev/null", &path).expect("a link");
        check_writable(&path).expect("writable");
        write_whole(&path, |out| out.write_all(b"new")).expect("written");
        assert!(path.is_symlink() && !fs::metadata(&path).expect("a device").is_file());
        assert_eq!(names(folder.path()), ["null.png"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_and_the_permissions_stay() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("folder");
        let (link, path) = (folder.path().join("link"), folder.path().join("a.png"));
        std::os::unix::fs::symlink("a.png", &link).expect("a link");
        for mode in [0o666, 0o640, 0o604] {
            if mode != 0o666 {
                fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("permissions");
            }
            write_whole(&link, |out| out.write_all(b"new")).expect("written");
            let there = fs::symlink_metadata(&path).expect("a file");
            assert!(there.is_file() && link.is_symlink());
            // A new file has the permissions that the umask leaves.
            assert!(mode == 0o666 || there.permissions().mode() & 0o777 == mode);
        }
        assert_eq!(fs::read(&path).expect("the file"), b"new");
    }

    #[test]
    fn a_check_leaves_nothing() {
        let folder = tempfile::tempdir().expect("folder");
        check_writable(&folder.path().join("a.png")).expect("writable");
        assert!(names(folder.path()).is_empty());
        assert!(check_writable(folder.path()).is_err());
        let none = check_writable(&folder.path().join("none/a.png"));
        assert!(none.is_err_and(|e| {
            e.to_string()
                .ends_with(": its folder does not exist; create it first")
        }));
        let long = check_writable(&folder.path().join("a".repeat(256)));
        assert!(long.is_err_and(|e| e.to_string().contains("too long")));
    }
}

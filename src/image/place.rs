//! Resolves the links of an output path.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{self, Path, PathBuf};

/// The target of an output path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A regular file, existing or new, with links resolved: it may be replaced.
    File(PathBuf),
    /// A device, a pipe, or an open file of a process: it must not be replaced.
    Straight(PathBuf),
}

/// A longer chain of links counts as a loop, as in Linux.
const MOST_LINKS: usize = 40;

impl Place {
    /// The target of `path`; an error if it cannot be a file.
    pub fn of(path: &Path) -> io::Result<Self> {
        let path = followed(path)?;
        match fs::metadata(&path) {
            Ok(there) if there.is_dir() => {
                Err(io::Error::new(ErrorKind::IsADirectory, "is a folder"))
            }
            Ok(there) if there.is_file() && !is_opened(&path) => Ok(Self::File(path)),
            Ok(_) => Ok(Self::Straight(path)),
            Err(cause) if cause.kind() != ErrorKind::NotFound => Err(cause),
            Err(_) if is_name(&path) => Ok(Self::File(path)),
            Err(_) => Err(io::Error::new(
                ErrorKind::InvalidInput,
                "is not a file name",
            )),
        }
    }
}

/// The folder of a file with this name.
pub fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// The path at the end of the links at `path`, whether or not it exists.
pub fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            Ok(to) if !is_opened(&path) => path = folder(&path).join(to),
            _ => return Ok(path),
        }
    }
    Err(io::Error::other("its links form a cycle"))
}

/// Whether Linux uses the name for an open file of a process, such as /proc/self/fd/1. The link's text is only a hint:
/// the file that it names may have been renamed or removed.
fn is_opened(path: &Path) -> bool {
    let folder = folder(path).canonicalize();
    path.is_symlink() && folder.is_ok_and(|folder| folder.starts_with("/proc"))
}

fn is_name(path: &Path) -> bool {
    let text = path.to_string_lossy();
    path.file_name().is_some() && !text.ends_with(path::is_separator)
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn links_lead_to_existing_or_new_files() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("in")).expect("a folder");
        fs::write(path("in/file"), "").expect("a file");
        for (link, to) in [
            ("in/second", "file"),
            ("first", "in/second"),
            ("dangling", "in/none"),
            ("a", "b"),
            ("b", "a"),
            ("in/up", "../first"),
        ] {
            symlink(to, path(link)).expect("a link");
        }
        symlink(path("first"), path("absolute")).expect("a link");
        symlink("/dev/null", path("null")).expect("a link");
        let of = |name: &str| Place::of(&path(name)).map_err(|error| error.to_string());
        let file = |name: &str| Ok(Place::File(path(name)));
        for name in ["in/file", "in/second", "first", "absolute"] {
            assert_eq!(of(name), file("in/file"), "{name}");
        }
        assert_eq!(of("in/up"), file("in/../in/file"));
        assert_eq!(
            (of("dangling"), of("none")),
            (file("in/none"), file("none"))
        );
        assert_eq!(of("null"), Ok(Place::Straight("/dev/null".into())));
        assert_eq!(of("a"), Err("its links form a cycle".to_owned()));
        assert_eq!(of("in"), Err("is a folder".to_owned()));
        assert_eq!(of("none/"), Err("is not a file name".to_owned()));
        assert!(Place::of(Path::new("")).is_err());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn paths_of_open_descriptors_are_used_straight() {
        use std::os::fd::AsRawFd;
        let file = tempfile::NamedTempFile::new().expect("a file");
        let number = file.as_raw_fd();
        for name in [
            format!("/dev/fd/{number}"),
            format!("/proc/self/fd/{number}"),
        ] {
            let name = PathBuf::from(name);
            assert_eq!(Place::of(&name).expect("open"), Place::Straight(name));
        }
    }
}

//! The identity of a file, independent of the names and links that lead to it.

use std::io;
use std::path::Path;

use same_file::Handle;

/// The identity of the file at `path`. Devices and pipes have none: many may write to one, and opening a pipe could block
/// forever.
pub fn of(path: &Path) -> Option<Handle> {
    let is_file = path.metadata().is_ok_and(|there| there.is_file());
    is_file.then(|| Handle::from_path(path).ok()).flatten()
}

/// The identity of the file that stdin is read from.
pub fn of_stdin() -> Option<Handle> {
    of_file(Handle::stdin())
}

/// The identity of the file that stdout is redirected into.
pub fn of_stdout() -> Option<Handle> {
    of_file(Handle::stdout())
}

/// The identity of the file that stderr is redirected into.
pub fn of_stderr() -> Option<Handle> {
    of_file(Handle::stderr())
}

fn of_file(stream: io::Result<Handle>) -> Option<Handle> {
    let is_file = |handle: &Handle| {
        let metadata = handle.as_file().metadata();
        metadata.is_ok_and(|there| there.is_file())
    };
    stream.ok().filter(is_file)
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn names_of_one_file_have_one_identity() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("in")).expect("a folder");
        for name in ["a", "b"] {
            fs::write(path(name), "the same").expect("a file");
        }
        fs::hard_link(path("a"), path("hard")).expect("a link");
        std::os::unix::fs::symlink("a", path("soft")).expect("a link");
        let a = of(&path("a"));
        assert!(a.is_some());
        for name in ["hard", "soft", "in/../a", "./a"] {
            assert_eq!(of(&path(name)), a, "{name}");
        }
        assert_ne!(of(&path("b")), a);
        assert_eq!(of(&path("none")), None);
        assert_eq!(of(&path("in")), None);
        assert_eq!(of(Path::new("/dev/null")), None);
    }
}

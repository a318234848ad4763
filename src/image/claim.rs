//! One writer per file at a time: a second writer of the same file is refused.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use same_file::Handle;

use super::file::FileError;
use super::place::{Place, folder};

/// While this exists, no other vkpt process writes the file.
#[derive(Debug)]
#[must_use = "the file is free again once this is dropped"]
pub struct Claim {
    _lock: Option<Lock>,
}

impl Claim {
    /// Claims the file that `path` resolves to. Devices and pipes accept any number of writers. If locking is not
    /// possible, as on a file system without locks, the file is written without one.
    ///
    /// # Errors
    /// Another process has claimed it.
    pub fn new(path: &Path) -> Result<Self, FileError> {
        let error = |cause| FileError {
            path: path.to_owned(),
            cause,
        };
        let Place::File(place) = Place::of(path).map_err(error)? else {
            return Ok(Self { _lock: None });
        };
        match Lock::take(beside(&place)) {
            Ok(lock) => Ok(Self { _lock: Some(lock) }),
            Err(TryLockError::Error(_)) => Ok(Self { _lock: None }),
            Err(TryLockError::WouldBlock) => Err(error(io::Error::other(
                "another vkpt is writing it; wait for it, or use another name",
            ))),
        }
    }
}

/// The path of a file's lock. The name is specific to vkpt, so that no other file is overwritten.
fn beside(file: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".vkpt-");
    name.push(file.file_name().unwrap_or_default());
    name.push(".lock");
    folder(file).join(name)
}

/// A locked file. The system unlocks it however the process ends; a lock file left by a killed process blocks nobody.
#[derive(Debug)]
struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    fn take(path: PathBuf) -> Result<Self, TryLockError> {
        loop {
            let file = open(&path).map_err(TryLockError::Error)?;
            file.try_lock()?;
            // Between opening and locking, the previous owner may have removed the file: a lock on it would block
            // nobody.
            let there = Handle::from_path(&path);
            let own = file.try_clone().and_then(Handle::from_file);
            if own.is_ok_and(|own| there.is_ok_and(|there| there == own)) {
                return Ok(Self { path, _file: file });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // The file is still locked: nobody else removes it, and a process that has it open will find it gone.
        let _ = fs::remove_file(&self.path);
    }
}

/// Opens or creates it. A file of another user may be read-only, which is enough for a lock.
fn open(path: &Path) -> io::Result<File> {
    let mut all = OpenOptions::new();
    let made = all.read(true).write(true).create(true).truncate(false);
    made.open(path).or_else(|_| File::open(path))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    #[test]
    fn a_file_has_one_claim_at_a_time_under_any_name() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("in")).expect("a folder");
        let first = Claim::new(&path("a.png")).expect("free");
        let other = Claim::new(&path("b.png")).expect("another file");
        let refused = Claim::new(&path("in/../a.png")).expect_err("claimed");
        assert!(refused.to_string().contains("/a.png: another vkpt"));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("a.png", path("link")).expect("a link");
            assert!(Claim::new(&path("link")).is_err());
            fs::remove_file(path("link")).expect("a link");
        }
        drop(first);
        drop(Claim::new(&path("a.png")).expect("free again"));
        drop(other);
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    }

    #[test]
    fn claims_of_killed_processes_bar_nobody() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.png");
        fs::write(beside(&path), "").expect("a lock file");
        drop(Claim::new(&path).expect("free"));
        assert!(!beside(&path).exists());
    }

    #[test]
    fn a_claim_without_a_lock_is_no_error() {
        let folder = tempfile::tempdir().expect("a folder");
        // The name of its lock would exceed the maximum length.
        let path = folder.path().join("a".repeat(250));
        let _both = [Claim::new(&path), Claim::new(&path)].map(|claim| claim.expect("claimed"));
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
        assert!(Claim::new(folder.path()).is_err(), "a folder");
    }

    /// Each writer removes the lock file, which the others may have open.
    #[test]
    fn of_many_that_come_and_go_one_at_a_time_has_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.png");
        let (holders, claims) = (AtomicU32::new(0), AtomicU32::new(0));
        let come_and_go = || {
            while claims.load(Ordering::SeqCst) < 2000 {
                let Ok(_claim) = Claim::new(&path) else {
                    continue;
                };
                assert_eq!(holders.fetch_add(1, Ordering::SeqCst), 0);
                claims.fetch_add(1, Ordering::SeqCst);
                holders.fetch_sub(1, Ordering::SeqCst);
            }
        };
        std::thread::scope(|scope| {
            (0..4).for_each(|_| drop(scope.spawn(come_and_go)));
        });
        assert!(!beside(&path).exists());
    }
}

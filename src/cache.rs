//! A folder of small files that processes leave for later ones. Any of them may be missing, broken or foreign: a file
//! is accepted only if it is complete and was written under the same key, and any failure counts as a missing file.

use std::fs::{self, File};
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use etcetera::BaseStrategy;

/// The start of every file: the format and its version.
const MAGIC: [u8; 8] = *b"vkptkc01";
/// Magic and checksum.
const HEADER: usize = 16;
/// The extension of all files. [`CacheFolder::trim`] uses it, because the folder may contain other files.
const ENDING: &str = "vkpt-cache";

/// The folder in `VKPT_CACHE`, none if that is empty; else the user's, `~/.cache/vkpt` on most systems, if its path is
/// absolute: a relative one would differ for every working directory.
pub fn from_env() -> Option<PathBuf> {
    match std::env::var_os("VKPT_CACHE") {
        Some(folder) if folder.is_empty() => None,
        Some(folder) => Some(folder.into()),
        None => {
            let user = etcetera::choose_base_strategy().ok()?.cache_dir();
            user.is_absolute().then(|| user.join("vkpt"))
        }
    }
}

/// Limits of the cache; the oldest files beyond them are removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    pub files: usize,
    /// Of all files together.
    pub bytes: u64,
}

/// Files by key: any text that identifies the dependencies of the content.
pub struct CacheFolder<'a> {
    folder: &'a Path,
    room: Room,
}

impl<'a> CacheFolder<'a> {
    /// The folder may not exist yet.
    pub fn new(folder: &'a Path, room: Room) -> Self {
        Self { folder, room }
    }

    /// The content last written under `key`.
    pub fn read(&self, key: &str) -> Option<Vec<u8>> {
        let path = self.path(key);
        let metadata = fs::metadata(&path).ok()?;
        // Reading something other than a file (a pipe, say) could block.
        if !metadata.is_file() || metadata.len() > self.room.bytes {
            return None;
        }
        let mut file = File::open(path).ok()?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).ok()?;
        let content = unseal(key, &bytes)?.to_vec();
        // The files unread for longest are removed first. If this fails, this file is removed earlier.
        let _ = file.set_modified(SystemTime::now());
        Some(content)
    }

    /// Stores `content` under `key`. Readers in other processes see the complete old file or the complete new one.
    pub fn write(&self, key: &str, content: &[u8]) -> io::Result<()> {
        fs::create_dir_all(self.folder)?;
        let mut file = tempfile::Builder::new()
            .suffix(&format!(".{ENDING}"))
            .tempfile_in(self.folder)?;
        file.write_all(&MAGIC)?;
        file.write_all(&checksum(key, content))?;
        file.write_all(content)?;
        file.persist(self.path(key))?;
        self.trim()
    }

    fn path(&self, key: &str) -> PathBuf {
        self.folder
            .join(format!("{:016x}.{ENDING}", hash(key.as_bytes())))
    }

    /// Removes the files unused for longest, including leftovers of a crash.
    fn trim(&self) -> io::Result<()> {
        let used = |entry: fs::DirEntry| {
            let (path, metadata) = (entry.path(), entry.metadata().ok()?);
            let ours = path.extension().is_some_and(|e| e == ENDING) && metadata.is_file();
            ours.then_some((metadata.modified().ok()?, metadata.len(), path))
        };
        let mut files: Vec<_> = fs::read_dir(self.folder)?
            .flatten()
            .filter_map(used)
            .collect();
        files.sort_unstable_by(|a, b| b.cmp(a));
        let mut total = 0;
        for (i, (_, bytes, path)) in files.into_iter().enumerate() {
            total += bytes;
            if i >= self.room.files || total > self.room.bytes {
                // Another process may already have removed it.
                let _ = fs::remove_file(path);
            }
        }
        Ok(())
    }
}

/// The content of a file that is complete and was written under `key`.
fn unseal<'a>(key: &str, file: &'a [u8]) -> Option<&'a [u8]> {
    let (header, content) = file.split_at_checked(HEADER)?;
    (header == [MAGIC, checksum(key, content)].concat()).then_some(content)
}

/// Checksum of key and content together: a file with another key fails like a broken one.
fn checksum(key: &str, content: &[u8]) -> [u8; 8] {
    let mut hasher = DefaultHasher::new();
    hasher.write_usize(key.len());
    hasher.write(key.as_bytes());
    hasher.write(content);
    hasher.finish().to_le_bytes()
}

/// SipHash. Another release of Rust's library may hash differently: each then ignores the other's files.
pub fn hash(bytes: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::time::Duration;

    use super::*;

    const FILES: usize = 64;
    const BYTES: u64 = 64 << 20;

    fn cache(folder: &Path) -> CacheFolder<'_> {
        let room = Room {
            files: FILES,
            bytes: BYTES,
        };
        CacheFolder::new(folder, room)
    }

    fn names(folder: &Path) -> BTreeSet<PathBuf> {
        let entries = fs::read_dir(folder).expect("a folder").flatten();
        entries.map(|entry| entry.path()).collect()
    }

    #[test]
    fn entries_are_read_back_under_their_key_alone() {
        let temporary = tempfile::tempdir().expect("a folder");
        let path = temporary.path().join("is/made");
        let folder = cache(&path);
        assert_eq!(folder.read("a"), None);
        for content in [&b"long ago"[..], b"", b"now"] {
            folder.write("a", content).expect("written");
            assert_eq!(folder.read("a").as_deref(), Some(content));
        }
        assert_eq!(folder.read("b"), None);
        fs::copy(folder.path("a"), folder.path("b")).expect("copied");
        assert_eq!(folder.read("b"), None, "a file of another key");
        folder.write("b", b"b's own").expect("replaced");
        assert_eq!(folder.read("b").as_deref(), Some(&b"b's own"[..]));
    }

    /// Every bit, every length, and targets that are no files.
    #[test]
    fn a_broken_file_is_as_good_as_none() {
        let temporary = tempfile::tempdir().expect("a folder");
        let folder = cache(temporary.path());
        folder.write("key", b"some content").expect("written");
        let (path, whole) = (
            folder.path("key"),
            fs::read(folder.path("key")).expect("read"),
        );
        let broken = |bytes: &[u8]| {
            fs::write(&path, bytes).expect("written");
            folder.read("key").is_none()
        };
        for bit in 0..8 * whole.len() {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(broken(&bytes), "bit {bit}");
        }
        for length in 0..whole.len() {
            assert!(broken(&whole[..length]), "{length} bytes");
        }
        assert!(broken(&[&whole[..], &[0]].concat()), "one byte more");
        assert!(!broken(&whole), "the whole file again");
        fs::remove_file(&path).expect("removed");
        fs::create_dir(&path).expect("a folder in its place");
        assert_eq!(folder.read("key"), None);
        assert!(folder.write("key", b"content").is_err());
        let files = names(temporary.path());
        assert_eq!(files, BTreeSet::from([path]), "nothing temporary is left");
    }

    #[test]
    fn an_impossible_folder_is_an_error_and_keeps_nothing() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let path = file.path().join("below a file");
        assert!(cache(&path).write("key", b"content").is_err());
        assert_eq!(cache(&path).read("key"), None);
    }

    #[test]
    fn the_files_used_longest_ago_go_first() {
        let temporary = tempfile::tempdir().expect("a folder");
        let folder = cache(temporary.path());
        let others = temporary.path().join("another's.txt");
        fs::write(&others, b"keep").expect("written");
        let start = SystemTime::now() - Duration::from_secs(1000);
        let key = |i: usize| format!("key {i}");
        for i in 0..FILES {
            folder.write(&key(i), b"content").expect("written");
            let file = File::open(folder.path(&key(i))).expect("a file");
            file.set_modified(start + Duration::from_secs(i as u64))
                .expect("dated");
        }
        assert!(folder.read(&key(0)).is_some(), "used again");
        folder.write(&key(FILES), b"content").expect("written");
        let gone: Vec<_> = (0..=FILES)
            .filter(|i| folder.read(&key(*i)).is_none())
            .collect();
        assert_eq!(gone, [1]);
        assert_eq!(names(temporary.path()).len(), FILES + 1);
        assert!(others.exists());
    }

    #[test]
    fn many_bytes_go_as_many_files_do() {
        let temporary = tempfile::tempdir().expect("a folder");
        let folder = cache(temporary.path());
        folder.write("old", b"content").expect("written");
        // Sparse: as large as the cache of a driver with huge kernels.
        let large = File::create(temporary.path().join("large.vkpt-cache")).expect("a file");
        large.set_len(BYTES).expect("grown");
        folder.write("new", b"content").expect("written");
        assert!(folder.read("new").is_some());
        assert_eq!(names(temporary.path()).len(), 1);
    }

    /// Threads represent processes: they share only the folder.
    #[test]
    fn readers_see_whole_files_while_others_write() {
        let temporary = tempfile::tempdir().expect("a folder");
        let contents: Vec<_> = (1..=4u8).map(|i| vec![i; 100_000 * i as usize]).collect();
        std::thread::scope(|scope| {
            for content in &contents {
                let path = temporary.path();
                scope.spawn(move || {
                    (0..50).for_each(|_| cache(path).write("key", content).expect("written"))
                });
            }
            for _ in 0..200 {
                let seen = cache(temporary.path()).read("key");
                assert!(seen.is_none_or(|content| contents.contains(&content)));
            }
        });
        let last = cache(temporary.path()).read("key");
        assert!(last.is_some_and(|content| contents.contains(&content)));
        assert_eq!(names(temporary.path()).len(), 1);
    }
}

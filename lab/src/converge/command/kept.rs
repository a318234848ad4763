//! References that vkpt rendered itself, cached on disk for later runs.

use std::fmt::{self, Write};
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::PathBuf;

use crate::converge::Halves;
use vkpt::cache::{self, CacheFolder, Room};
use vkpt::render::Job;

/// Of a full HD picture both halves take 50 MB.
const ROOM: Room = Room {
    files: 64,
    bytes: 1 << 30,
};

/// Where the halves of one job are cached, if anywhere.
pub struct Kept {
    folder: Option<PathBuf>,
    key: String,
}

/// The folder of all references.
fn folder() -> Option<PathBuf> {
    cache::from_env().map(|folder| folder.join("references"))
}

/// The files that earlier runs left, any of which may be read.
pub fn files() -> Vec<PathBuf> {
    let entries = folder().and_then(|folder| fs::read_dir(folder).ok());
    let entries = entries.into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).collect()
}

impl Kept {
    pub fn new(job: &Job) -> Self {
        Self {
            folder: folder(),
            key: key(job),
        }
    }

    /// The halves of an earlier run: of the crop's size, and rendered for at least about `seconds`.
    pub fn read(&self, size: [u32; 2], seconds: f64) -> Option<Halves> {
        let folder = self.folder.as_deref()?;
        let bytes = CacheFolder::new(folder, ROOM).read(&self.key)?;
        let halves = Halves::from_bytes(&bytes)?;
        let film = &halves.films[0];
        let fits = [film.width, film.height] == size && halves.seconds >= 0.9 * seconds;
        fits.then_some(halves)
    }

    /// Writes them for later runs. A cache that cannot be written is not an error.
    pub fn write(&self, halves: &Halves) {
        if let Some(folder) = self.folder.as_deref() {
            let _ = CacheFolder::new(folder, ROOM).write(&self.key, &halves.to_bytes());
        }
    }
}

/// Everything that the halves depend on, except the number of samples: this build of vkpt, the model, and the prepared
/// scene with every vertex of its meshes.
fn key(job: &Job) -> String {
    let mut scene = Hashed(DefaultHasher::new());
    // A hasher accepts any text.
    let _ = write!(scene, "{:?}", job.prepared);
    format!(
        "reference\nvkpt {}\n{}\n{:?}\n{:?}\nscene {:016x}",
        env!("CARGO_PKG_VERSION"),
        build(),
        job.settings.model,
        job.crop,
        scene.0.finish()
    )
}

/// Size and date of the program: during development its version does not identify it.
fn build() -> String {
    let metadata = std::env::current_exe().and_then(std::fs::metadata);
    metadata.map_or(String::new(), |m| {
        format!("{} {:?}", m.len(), m.modified().ok())
    })
}

/// Hashes text as it is written: that of a large mesh would not fit into memory.
struct Hashed(DefaultHasher);

impl Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

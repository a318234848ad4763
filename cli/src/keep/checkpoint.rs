//! Writing a part to disk while a rendering continues.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use vkpt::image::file::write_whole;
use vkpt::part::AnyPart;
use vkpt::state::{self, Header};
use vkpt_lab::cli::exit::{note, warn};

/// Writing takes at most one part in this many of the time: the pause is extended as needed.
const SHARE: u32 = 100;

/// Where checkpoints go, and when.
pub struct Checkpoint {
    path: PathBuf,
    pause: Duration,
    /// When the last one was written, or when the rendering started.
    last: Instant,
    /// How long that took.
    took: Duration,
    /// Whether one has been written.
    pub written: bool,
    failed: bool,
}

impl Checkpoint {
    /// Time starts now. `written`: whether a checkpoint exists that must be kept up to date.
    pub fn new(path: PathBuf, pause: Duration, written: bool) -> Self {
        Self {
            path,
            pause,
            last: Instant::now(),
            took: Duration::ZERO,
            written,
            failed: false,
        }
    }

    /// Whether one is due.
    pub fn is_due(&self) -> bool {
        self.last.elapsed() >= self.pause.max(self.took * SHARE)
    }

    /// Writes the one that `make` makes. A failure gives one warning, and the rendering continues: the disk may have space
    /// next time.
    pub fn write(&mut self, make: impl FnOnce() -> (Header, AnyPart)) {
        let start = Instant::now();
        let (header, part) = make();
        let written = write_whole(&self.path, |out| state::write(out, &header, &part));
        self.last = Instant::now();
        self.took = start.elapsed();
        self.written |= written.is_ok();
        match written {
            Ok(()) if self.failed => {
                note(&format!("{} can be written again", self.path.display()));
                self.failed = false;
            }
            Ok(()) => {}
            Err(error) if !self.failed => {
                warn(&format!(
                    "cannot write {error}; the rendering continues, and tries again later"
                ));
                self.failed = true;
            }
            Err(_) => {}
        }
    }
}

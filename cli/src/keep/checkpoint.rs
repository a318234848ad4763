//! Leaving a part on disk while a rendering goes on.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use vkpt::image::file::write_whole;
use vkpt::part::AnyPart;
use vkpt::state::{self, Header};
use vkpt_lab::cli::exit::{note, warn};

/// Writing takes at most this part of the time: the pause is as much longer as need be.
const SHARE: u32 = 100;

/// Where checkpoints go, and when.
pub struct Checkpoint {
    path: PathBuf,
    pause: Duration,
    /// When the last one was written, or the rendering began.
    last: Instant,
    /// How long that took.
    took: Duration,
    /// Whether there is one by now.
    pub written: bool,
    failed: bool,
}

impl Checkpoint {
    /// Time begins now. `written`: whether there is one that is to be kept true.
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

    /// Writes the one that `make` makes. What cannot be written is said once, and the rendering goes on: the disk may have room
    /// by the next time.
    pub fn write(&mut self, make: impl FnOnce() -> (Header, AnyPart)) {
        let start = Instant::now();
        let (header, part) = make();
        let written = write_whole(&self.path, |out| state::write(out, &header, &part));
        self.last = Instant::now();
        self.took = start.elapsed();
        self.written |= written.is_ok();
        match written {
            Ok(()) if self.failed => {
                note(&format!("{} is written again", self.path.display()));
                self.failed = false;
            }
            Ok(()) => {}
            Err(error) if !self.failed => {
                warn(&format!(
                    "cannot write {error}; the rendering goes on, and tries again"
                ));
                self.failed = true;
            }
            Err(_) => {}
        }
    }
}

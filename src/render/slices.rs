//! The number of samples of a dispatch: few at first, then as many as fit the target duration.

use std::time::Duration;

/// The default duration of a dispatch: long enough to keep the device busy, short enough for ctrl-c, a progress bar and
/// any watchdog.
pub const WANTED: Duration = Duration::from_millis(75);

/// The size of the next slice of samples, learnt from the last. The picture does not depend on it.
#[derive(Debug)]
pub struct Slices {
    samples: u32,
    /// The target duration of a dispatch.
    wanted: Duration,
}

impl Slices {
    pub fn new(wanted: Duration) -> Self {
        Self { samples: 1, wanted }
    }

    /// Samples of the next slice, at most `left`.
    pub fn next(&self, left: u32) -> u32 {
        self.samples.min(left)
    }

    /// Learns that a slice of `samples` took `time`; at most doubles, so that one quick slice misleads little.
    pub fn took(&mut self, samples: u32, time: Duration) {
        let wanted = f64::from(samples) * self.wanted.as_secs_f64() / time.as_secs_f64().max(1e-6);
        self.samples = (wanted as u32).clamp(1, self.samples.saturating_mul(2));
    }
}

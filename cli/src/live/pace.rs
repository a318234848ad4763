//! The pace of snapshots: rare enough not to slow the rendering.

use std::time::{Duration, Instant};

/// The minimum time between two.
const PAUSE: Duration = Duration::from_secs(1);

/// Making them takes at most one part in this many of the time: the pause is extended as needed.
const SHARE: u32 = 100;

/// When the last one was made, and its duration.
#[derive(Debug, Default)]
pub struct Pace {
    last: Option<(Instant, Duration)>,
}

impl Pace {
    /// Whether there is time for one.
    pub fn is_due(&self) -> bool {
        let pause = |took: Duration| PAUSE.max(took * SHARE);
        self.last
            .is_none_or(|(end, took)| end.elapsed() >= pause(took))
    }

    /// Records one that was started at `start`.
    pub fn made(&mut self, start: Instant) {
        self.last = Some((Instant::now(), start.elapsed()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_pictures_are_made_less_often() {
        let mut pace = Pace::default();
        assert!(pace.is_due(), "the first at once");
        pace.made(Instant::now());
        assert!(!pace.is_due());
        let ended = |ago, took| Pace {
            last: Instant::now()
                .checked_sub(Duration::from_millis(ago))
                .map(|end| (end, Duration::from_millis(took))),
        };
        assert!(ended(1100, 1).is_due());
        assert!(!ended(900, 1).is_due());
        assert!(!ended(1100, 20).is_due(), "20 ms are 1 % of 2 s");
        assert!(ended(2100, 20).is_due());
    }
}

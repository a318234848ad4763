//! Counters of samples.

use serde::{Deserialize, Serialize};

use crate::sample::Largest;

/// Counts of all pixels together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    pub rays: u64,
    pub long_paths: u64,
    pub underflows: u64,
    pub dropped: Dropped,
}

/// Samples that count as 0, by cause.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Dropped {
    pub nan: u64,
    pub infinite: u64,
    pub loops: u64,
}

/// The counters, and the sample with the brightest channel; `None` if all are black.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    pub counts: Counts,
    pub largest: Option<Largest>,
}

impl Counts {
    /// Adds both. Counts saturate at 2⁶⁴ − 1, because a file may contain any value.
    pub fn plus(self, other: Self) -> Self {
        let dropped = Dropped {
            nan: self.dropped.nan.saturating_add(other.dropped.nan),
            infinite: self.dropped.infinite.saturating_add(other.dropped.infinite),
            loops: self.dropped.loops.saturating_add(other.dropped.loops),
        };
        Self {
            rays: self.rays.saturating_add(other.rays),
            long_paths: self.long_paths.saturating_add(other.long_paths),
            underflows: self.underflows.saturating_add(other.underflows),
            dropped,
        }
    }
}

impl Tally {
    /// Combines it with the tally of later samples: among equally bright ones of a pixel the first counts.
    pub fn plus(self, later: Self) -> Self {
        Self {
            counts: self.counts.plus(later.counts),
            largest: match (self.largest, later.largest) {
                (Some(a), Some(b)) => Some(a.or(b)),
                (a, b) => a.or(b),
            },
        }
    }
}

//! Parts of one picture as they come in, from several devices.

use std::collections::BTreeMap;

use super::course::Course;
use super::follow::Watch;
use super::outcome::Stats;
use crate::part::{AnyPart, Part};

/// The parts so far.
pub struct Joining {
    /// From the first sample on, without a gap.
    pub whole: Part<f32>,
    /// Behind a gap, by their first sample.
    waiting: BTreeMap<u32, Part<f32>>,
    pub stats: Vec<Option<Stats>>,
}

impl Joining {
    /// Continues a part, with this many devices.
    pub fn new(whole: Part<f32>, devices: usize) -> Self {
        Self {
            whole,
            waiting: BTreeMap::new(),
            stats: vec![None; devices],
        }
    }

    /// Joins a part, or makes it wait for those before it.
    pub fn take(&mut self, part: Part<f32>, course: &mut Course, watch: &mut dyn Watch) {
        self.waiting.insert(part.range().start, part);
        while let Some(next) = self.waiting.remove(&self.whole.range().end) {
            // They are of one job, and one begins where the other ends.
            let joined = self.whole.append(next, &mut |whole| {
                course.joined(whole.range().end, || whole.halves());
            });
            debug_assert_eq!(joined, Ok(()));
            watch.progress(course.progress(self.whole.range().end, 1.0));
            watch.reached(&|| course.so_far(self.part(), self.stats()));
        }
    }

    pub fn part(&self) -> AnyPart {
        AnyPart::F32(self.whole.clone())
    }

    /// Statistics of all devices together.
    pub fn stats(&self) -> Stats {
        let all: Vec<&Stats> = self.stats.iter().flatten().collect();
        let first = all.first().map_or(Stats::default(), |&first| first.clone());
        let joined = |of: fn(&Stats) -> &String| {
            let mut names: Vec<&str> = all.iter().map(|stats| &**of(stats)).collect();
            names.dedup();
            names.join(", ")
        };
        let most = |of: fn(&Stats) -> f64| all.iter().map(|s| of(s)).fold(0.0, f64::max);
        Stats {
            device: joined(|s| &s.device),
            driver: joined(|s| &s.driver),
            rounding: joined(|s| &s.rounding),
            compile_s: most(|s| s.compile_s),
            gpu_s: None,
            ..first
        }
    }
}

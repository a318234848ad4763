//! The remaining time of a rendering.

use std::time::Instant;

use vkpt::render::Progress;

/// The reports of progress.
#[derive(Debug, Default)]
pub struct Clock {
    /// The first report: for a resumed rendering, much is already done.
    first: Option<(Instant, f64)>,
    last: Option<(Instant, Progress)>,
}

impl Clock {
    /// Records a report.
    pub fn report(&mut self, progress: Progress) {
        let now = Instant::now();
        self.first.get_or_insert((now, progress.fraction));
        self.last = Some((now, progress));
    }

    /// The last report.
    pub fn progress(&self) -> Option<Progress> {
        self.last.map(|(_, progress)| progress)
    }

    /// Seconds left, by the pace from the first report to the last.
    pub fn seconds_left(&self) -> Option<f64> {
        let ((begun, from), (then, progress)) = self.first.zip(self.last)?;
        let made = progress.fraction - from;
        let pace = (then - begun).as_secs_f64() / made;
        let left = pace * (1.0 - progress.fraction) - then.elapsed().as_secs_f64();
        (made > 0.0).then_some(left.max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn samples_done_before_the_start_do_not_count_as_speed() {
        let at = |ago: u64, fraction| {
            let then = Instant::now().checked_sub(Duration::from_secs(ago));
            let progress = Progress {
                samples_done: 1,
                spp: 9,
                fraction,
            };
            (then.expect("a clock that runs"), progress)
        };
        let left = |first: (Instant, Progress), last| {
            let clock = Clock {
                first: Some((first.0, first.1.fraction)),
                last: Some(last),
            };
            clock.seconds_left()
        };
        let near = |left: Option<f64>, s: f64| left.is_some_and(|left| (left - s).abs() < 0.1);
        assert!(near(left(at(10, 0.0), at(0, 0.5)), 10.0));
        assert!(near(left(at(10, 0.8), at(0, 0.9)), 10.0));
        assert!(near(left(at(12, 0.0), at(2, 0.5)), 8.0), "time goes on");
        assert!(near(left(at(90, 0.0), at(80, 0.5)), 0.0));
        assert_eq!(left(at(1, 0.5), at(1, 0.5)), None);
        assert_eq!(Clock::default().seconds_left(), None);
    }
}

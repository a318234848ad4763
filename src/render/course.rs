//! The course of a rendering: slice after slice until the requested samples, seconds or error are reached.
//!
//! Neither the slices nor the times of the error estimates influence the picture.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::slices::Slices;
use super::{Job, Outcome, Progress, Start, State, Stats};
use crate::metrics::noise::{Culprits, RelMse, rel_mse};
use crate::part::{AnyPart, Halves};

/// When a rendering ends before it has all its samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Until {
    /// After this many seconds of rendering, compiling not included. Above 0.
    pub seconds: Option<f64>,
    /// The upper end of the estimated relMSE is below this. Above 0.
    pub rel_mse: Option<f64>,
}

/// Why a rendering ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All samples are complete.
    Complete,
    /// Interrupted by the caller.
    Interrupted,
    /// [`Until::seconds`] are over.
    Time,
    /// [`Until::rel_mse`] is reached.
    Error,
    /// The device failed twice.
    Lost,
}

/// The error of the picture at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorAt {
    /// Samples in every pixel.
    pub spp: u32,
    /// Seconds of rendering so far, without compiling.
    pub seconds: f64,
    /// `None` for one sample, which gives no estimate, and for a picture that overflows. Pixels are
    /// those of the full picture.
    pub rel_mse: Option<RelMse>,
}

/// Decides on the next slice, and records the errors.
pub struct Course<'a> {
    job: &'a Job<'a>,
    stop: &'a AtomicBool,
    start: Instant,
    /// Seconds of rendering before that.
    before: f64,
    slices: Slices,
    /// When the current slice began, in seconds.
    began: f64,
    /// Seconds per sample index of the last slice, in all tiles.
    pace: f64,
    /// The index of the first sample.
    first: u32,
    /// The index of the next sample.
    done: u32,
    end: Option<End>,
    errors: Vec<ErrorAt>,
}

impl<'a> Course<'a> {
    /// Time begins now.
    pub fn new(job: &'a Job, stop: &'a AtomicBool, start: &Start, wanted: Duration) -> Self {
        let range = start.range();
        let state = start.state();
        let mut course = Self {
            job,
            stop,
            start: Instant::now(),
            before: state.map_or(0.0, |s| s.seconds),
            slices: Slices::new(wanted),
            began: 0.0,
            pace: 0.0,
            first: range.start,
            done: range.end,
            end: None,
            errors: state.map_or(Vec::new(), |s| s.errors.clone()),
        };
        course.end = match course.samples() {
            0 => stop.load(Ordering::Relaxed).then_some(End::Interrupted),
            _ => course.spent(),
        };
        if let (Some(_), Some(state)) = (course.end, state) {
            course.look_at_the_end(|| state.part.halves());
        }
        course
    }

    /// Whether no slice is to follow.
    pub fn has_ended(&self) -> bool {
        self.end.is_some()
    }

    /// Samples that every pixel has.
    fn samples(&self) -> u32 {
        self.done - self.first
    }

    /// Seconds of rendering so far.
    fn seconds(&self) -> f64 {
        self.before + self.start.elapsed().as_secs_f64()
    }

    /// The index of the sample to which the next slice is to bring every pixel; `None` at the end.
    pub fn next_slice(&mut self) -> Option<u32> {
        if self.end.is_some() {
            return None;
        }
        self.began = self.seconds();
        let slice = self.slices.next(self.next_look() - self.done);
        let left = self.job.until.seconds.map(|s| s - self.began);
        let fit = left.map_or(u32::MAX, |left| (left / self.pace) as u32);
        Some(self.done + slice.min(fit).max(1))
    }

    /// Every pixel has all samples before the index `samples`, and the longest dispatch took `longest`; `halves` is
    /// called for the picture when an error estimate is due.
    pub fn reached(&mut self, samples: u32, longest: Duration, halves: impl FnOnce() -> Halves) {
        let slice = samples - self.done;
        self.slices.took(slice, longest);
        self.pace = (self.seconds() - self.began) / f64::from(slice);
        let due = samples == self.next_look();
        self.done = samples;
        self.end = self.spent();
        if due || self.end.is_some() {
            self.look(halves);
        }
        if due && self.end.is_none() && self.is_close() {
            self.end = Some(End::Error);
        }
    }

    /// Samples of another part were joined: every pixel has all before the index `samples`.
    pub fn joined(&mut self, samples: u32, halves: impl FnOnce() -> Halves) {
        let due = self.next_look() <= samples;
        self.done = samples;
        if due {
            self.look(halves);
        }
        let closed = || due && self.is_close();
        let end = self.end.or_else(|| self.spent());
        self.end = end.or_else(|| closed().then_some(End::Error));
    }

    /// Estimates the error after the last sample, unless it was estimated there.
    pub fn look_at_the_end(&mut self, halves: impl FnOnce() -> Halves) {
        let samples = self.samples();
        if samples > 0 && self.errors.last().is_none_or(|last| last.spp < samples) {
            self.look(halves);
        }
    }

    /// The progress once the current slice, which ends at the index `samples`, has made `part` of its own.
    pub fn progress(&self, samples: u32, part: f64) -> Progress {
        let slice = samples - self.done;
        let all = self.job.spp - self.first;
        let whole = if part == 1.0 { slice } else { 0 };
        let made = f64::from(self.samples()) + part * f64::from(slice);
        let wanted = self.samples_wanted().min(f64::from(all));
        let spent = self.job.until.seconds.map_or(0.0, |s| self.seconds() / s);
        Progress {
            samples_done: self.samples() + whole,
            spp: all,
            fraction: (made / wanted).max(spent).min(1.0),
        }
    }

    /// The rendering so far: interrupted, if it has not ended.
    pub fn so_far(&self, part: AnyPart, stats: Stats) -> Outcome {
        let state = State {
            part,
            errors: self.errors.clone(),
            seconds: self.seconds(),
        };
        let end = self.end.unwrap_or(End::Interrupted);
        Outcome::new(self.job, state, end, stats)
    }

    /// Whether samples, patience or time are used up.
    fn spent(&self) -> Option<End> {
        let seconds = self.job.until.seconds;
        match () {
            () if self.done >= self.job.spp => Some(End::Complete),
            () if self.stop.load(Ordering::Relaxed) => Some(End::Interrupted),
            () if seconds.is_some_and(|s| self.seconds() >= s) => Some(End::Time),
            () => None,
        }
    }

    /// Whether the error is as small as requested.
    fn is_close(&self) -> bool {
        let high = self.upper_end();
        let close = self.job.until.rel_mse.zip(high).map(|(e, high)| high < e);
        close.unwrap_or(false)
    }

    /// The upper end of the last interval.
    fn upper_end(&self) -> Option<f64> {
        let last = self.errors.last()?.rel_mse?;
        last.interval.ok().map(|[_, high]| high)
    }

    /// Roughly the number of samples that the requested error takes: the error is inverse to their number.
    fn samples_wanted(&self) -> f64 {
        let last = self.errors.last().map(|e| f64::from(e.spp));
        let ratio = self
            .job
            .until
            .rel_mse
            .zip(self.upper_end())
            .map(|(e, high)| high / e);
        last.zip(ratio).map_or(f64::INFINITY, |(n, r)| n * r)
    }

    /// The number of samples at which the error is estimated next.
    fn next_look(&self) -> u32 {
        let look = next_look(self.samples(), self.job.until.rel_mse.is_some());
        self.first.saturating_add(look).min(self.job.spp)
    }

    fn look(&mut self, halves: impl FnOnce() -> Halves) {
        let area = self.job.area();
        let seconds = self.seconds();
        let samples = self.samples();
        look(&mut self.errors, samples, seconds, [area.x, area.y], halves);
    }
}

/// Adds the error of a picture of `spp` samples, whose first pixel is `origin` of the full picture, to those before. An
/// estimate between two powers of two is dropped when the next one comes.
pub fn look(
    errors: &mut Vec<ErrorAt>,
    spp: u32,
    seconds: f64,
    origin: [u32; 2],
    halves: impl FnOnce() -> Halves,
) {
    errors.pop_if(|last| !last.spp.is_power_of_two());
    let of = |h: Halves| rel_mse(&h.mean, &h.half_difference).ok();
    let mut rel_mse = (spp >= 2).then(halves).and_then(of);
    if let Some(Err(Culprits { worst, .. })) = rel_mse.as_mut().map(|r| &mut r.interval) {
        *worst = [origin[0] + worst[0], origin[1] + worst[1]];
    }
    errors.push(ErrorAt {
        spp,
        seconds,
        rel_mse,
    });
}

/// The number of samples at which the error is estimated next, when every pixel has `done`: at powers of two.
/// `closely`, when the error decides on the end, also at every eighth of one; otherwise a rendering could take twice as
/// long as it needs. Depends on no clock. An estimate beyond 2³² − 1 samples, which no pixel gets, is that number.
fn next_look(done: u32, closely: bool) -> u32 {
    let octave = done.checked_ilog2().map_or(0, |log| 1 << log);
    let step = if closely { octave / 8 } else { octave }.max(1);
    (done / step + 1).saturating_mul(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_come_after_powers_of_two_and_eighths_of_them() {
        let looks = |closely, count| {
            let next = |&done: &u32| Some(next_look(done, closely));
            let all: Vec<u32> = std::iter::successors(Some(0), next).take(count).collect();
            all
        };
        assert_eq!(looks(false, 7), [0, 1, 2, 4, 8, 16, 32]);
        let closely = [
            0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 24, 26, 28, 30,
            32, 36,
        ];
        assert_eq!(looks(true, 26), closely);
        // A rendering may end anywhere.
        assert_eq!((next_look(33, false), next_look(33, true)), (64, 36));
    }

    #[test]
    fn the_last_look_is_beyond_all_samples() {
        let half = 1 << 31;
        assert_eq!(next_look(half, true), half + half / 8);
        for done in [half, u32::MAX - 1, u32::MAX] {
            assert_eq!(next_look(done, false), u32::MAX, "{done}");
        }
        assert_eq!(next_look(u32::MAX, true), u32::MAX);
    }
}

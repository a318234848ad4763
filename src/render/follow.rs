//! Runs a rendering on any device: slice after slice, with a watcher.

use std::time::Duration;

use super::course::Course;
use super::{Outcome, Progress, RenderError, Stats};
use crate::part::AnyPart;

/// A film and its accumulator.
pub trait Grows {
    /// Brings every pixel to the sample of index `samples` and reports the part of that which is done; returns the
    /// longest dispatch.
    ///
    /// # Errors
    /// Those of a device. The samples that every pixel has by then stay.
    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError>;

    /// All samples that every pixel has.
    fn part(&self) -> AnyPart;

    /// Statistics, except those that the part contains.
    fn stats(&self) -> Stats;
}

/// Receives the events of a rendering. Nothing that it does influences the picture.
pub trait Watch {
    /// Called now and then.
    fn progress(&mut self, progress: Progress);

    /// Called after each slice; `so_far` makes the outcome as if it were the last.
    fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        let _ = so_far;
    }

    /// A device failed; `then` says how the rendering continues.
    fn lost(&mut self, error: &RenderError, then: &str) {
        let _ = (error, then);
    }
}

impl<F: FnMut(Progress)> Watch for F {
    fn progress(&mut self, progress: Progress) {
        self(progress);
    }
}

/// Follows the course to its end.
pub fn follow(
    course: &mut Course,
    run: &mut dyn Grows,
    watch: &mut dyn Watch,
) -> Result<(), RenderError> {
    while let Some(samples) = course.next_slice() {
        let mut part = |part| watch.progress(course.progress(samples, part));
        let longest = run.advance(samples, &mut part)?;
        course.reached(samples, longest, || run.part().halves());
        watch.reached(&|| course.so_far(run.part(), run.stats()));
    }
    Ok(())
}

//! A rendering under way, whatever renders: slice after slice, and somebody who watches.

use std::time::Duration;

use super::course::Course;
use super::{Outcome, Progress, RenderError, Stats};
use crate::part::AnyPart;

/// A film, and what adds samples to it.
pub trait Grows {
    /// Brings every pixel to the sample of index `samples` and reports the part of that which is done; returns the longest
    /// dispatch.
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

    /// What it took, but for what the part tells.
    fn stats(&self) -> Stats;
}

/// Who is told what happens. Nothing that it does has an influence on the picture.
pub trait Watch {
    /// Now and then.
    fn progress(&mut self, progress: Progress);

    /// After each slice; `so_far` makes what would come out if it were the last.
    fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        let _ = so_far;
    }

    /// A device failed; `then` says how the rendering goes on.
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

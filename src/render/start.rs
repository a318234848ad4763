//! Where a rendering begins.

use std::ops::Range;

use super::{ErrorAt, Job, RenderError, empty_part};
use crate::part::{AnyPart, Part, Scalar};

/// The samples of a rendering so far, from which it can be continued.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    pub part: AnyPart,
    /// The error estimates after 1, 2, 4 … of its samples, and after the last at which one was made.
    pub errors: Vec<ErrorAt>,
    /// Seconds of rendering.
    pub seconds: f64,
}

/// Where a rendering begins: with the sample of this index, or after the samples so far.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    At(u32),
    After(State),
}

impl Start {
    /// The completed samples.
    pub fn range(&self) -> Range<u32> {
        match self {
            Self::At(index) => *index..*index,
            Self::After(state) => state.part.range(),
        }
    }

    pub(super) fn state(&self) -> Option<&State> {
        match self {
            Self::At(_) => None,
            Self::After(state) => Some(state),
        }
    }

    /// The part to continue.
    ///
    /// # Errors
    /// [`RenderError::Start`] if it is of another size, scalar or kind than the job's.
    pub(super) fn part<F: Scalar>(&self, job: &Job) -> Result<Part<F>, RenderError> {
        let empty = empty_part(job, self.range().start);
        let Some(state) = self.state() else {
            return Ok(empty);
        };
        let part = F::of(state.part.clone());
        part.filter(|part| part.size() == empty.size())
            .filter(|part| part.keeps() == empty.keeps())
            .ok_or(RenderError::Start)
    }
}

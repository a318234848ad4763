//! Joins consecutive parts.

use std::ops::Range;
use std::sync::Arc;

use super::layout::{BLOCK, in_head};
use super::{Part, Sums};
use crate::reference::math::{Real, Vec3};

/// Why one part cannot be appended to another.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Misfit {
    #[error("it has {} pixels, not {}", by(.0), by(.1))]
    Size([u32; 2], [u32; 2]),
    #[error(
        "not all parts have the data for standard errors (--aov stderr) or a denoised picture (--denoise)"
    )]
    Keeps,
    #[error(
        "one of the parts was rendered by cpu-f64 and another in single precision: join parts of one precision"
    )]
    Scalar,
    #[error("it starts at sample {}, not {}", .0.start, .1.end)]
    Range(Range<u32>, Range<u32>),
}

fn by(size: &[u32; 2]) -> String {
    format!("{}x{}", size[0], size[1])
}

impl<F: Real> Part<F> {
    /// Adds the samples of `next`, which begins where this part ends, and calls `look` after each step. Whenever the
    /// number of samples is a power of two, a step ends there, unless it is within the range of the first part.
    pub fn append(&mut self, next: Self, look: &mut dyn FnMut(&Self)) -> Result<(), Misfit> {
        if self.size != next.size {
            return Err(Misfit::Size(next.size, self.size));
        }
        if self.keeps != next.keeps {
            return Err(Misfit::Keeps);
        }
        if self.range.end != next.range.start {
            return Err(Misfit::Range(next.range(), self.range()));
        }
        self.tally = self.tally.plus(next.tally);
        for values in next.head {
            self.add(values);
            look(self);
        }
        for node in next.nodes {
            self.push(node);
            look(self);
        }
        if let Some(tail) = next.tail {
            self.range.end += tail.samples;
            self.tail = Some(tail);
            look(self);
        }
        Ok(())
    }

    /// Adds a sample to every pixel.
    fn add(&mut self, values: Arc<Vec<Vec3<F>>>) {
        if in_head(self.range.start, self.range.end) {
            self.head.push(values);
            self.range.end += 1;
            return;
        }
        let none = || Arc::new(Sums::zero(values.len(), self.keeps));
        let mut tail = self.tail.take().unwrap_or_else(none);
        Arc::make_mut(&mut tail).add(&values);
        if tail.samples == BLOCK {
            self.range.end -= BLOCK - 1;
            self.push(tail);
        } else {
            self.range.end += 1;
            self.tail = Some(tail);
        }
    }
}

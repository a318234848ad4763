//! A part of a picture: samples A up to B of every pixel, as sums that join with those of other parts to the sums of
//! one rendering, bit for bit, regardless of how the samples were divided.
//!
//! Sums of floats depend on the order of addition, so the order is fixed by the indices of samples alone. Samples
//! i·[`BLOCK`] to (i + 1)·[`BLOCK`] are a *block*, added one after the other from zero, as in a film. Whole blocks are
//! joined in pairs, pairs in pairs, and so on: a *node* of level k consists of the blocks j·2ᵏ to (j + 1)·2ᵏ, and is
//! the sum of the two nodes below it. The sums of a picture are those of the largest nodes that its samples fill, from
//! left to right, then of the incomplete block.
//!
//! ```text
//! samples    0   256   512   768  1024  1280  1400
//! nodes      ╰──────────╮╭──────────╯ ╰──╯  ╰╴ the incomplete block
//! ```
//!
//! A part keeps the largest nodes within its range, at most two per level; the sums of the incomplete block at its end;
//! and if it begins inside a block, the values of the samples up to that block's end, because they must be added to
//! sums of another part. So the content of a part follows from its range ([`Layout`]): a range from one multiple of a
//! power of two to the next is one node.

mod any;
mod append;
mod beside;
mod develop;
mod layout;
mod quarters;
mod sums;
mod tally;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::sync::Arc;

use crate::film::Keeps;
use crate::reference::math::{Real, Vec3};
pub use any::{AnyPart, Scalar};
pub use append::Misfit;
pub use beside::{Beside, BesideMut};
pub use develop::Halves;
pub use layout::{BLOCK, Layout};
pub use quarters::Half;
pub use sums::{PixelSums, Sums};
pub use tally::{Counts, Dropped, Tally};

/// Samples of every pixel of a picture, or of its crop. Clones share the sums.
#[derive(Clone, Debug, PartialEq)]
pub struct Part<F> {
    /// Width and height in pixels.
    size: [u32; 2],
    keeps: Keeps,
    /// Indices of the samples.
    range: Range<u32>,
    /// The samples of each index before the first block that begins here: one value per pixel, row by row.
    head: Vec<Arc<Vec<Vec3<F>>>>,
    /// Sums of whole blocks, from left to right.
    nodes: Vec<Arc<Sums<F>>>,
    /// Sums of the incomplete block, if it begins here and has samples.
    tail: Option<Arc<Sums<F>>>,
    pub tally: Tally,
}

impl<F: Real> Part<F> {
    /// A part without samples; the first will have the index `begin`.
    pub fn new(size: [u32; 2], keeps: Keeps, begin: u32) -> Self {
        Self {
            size,
            keeps,
            range: begin..begin,
            head: Vec::new(),
            nodes: Vec::new(),
            tail: None,
            tally: Tally::default(),
        }
    }

    /// Builds a part from the samples of the head and the sums of nodes and tail, in the order of its [`Layout`].
    pub fn assembled(empty: Self, end: u32, head: Vec<Vec<Vec3<F>>>, sums: Vec<Sums<F>>) -> Self {
        let range = empty.range.start..end;
        let Layout { tail, .. } = Layout::new(range.clone());
        let mut nodes: Vec<_> = sums.into_iter().map(Arc::new).collect();
        let tail = if tail > 0 { nodes.pop() } else { None };
        Self {
            range,
            head: head.into_iter().map(Arc::new).collect(),
            nodes,
            tail,
            ..empty
        }
    }

    /// The samples of each index of the head.
    pub fn head(&self) -> impl Iterator<Item = &[Vec3<F>]> {
        self.head.iter().map(|values| &values[..])
    }

    /// The sums of the nodes, from left to right, and of the tail.
    pub fn sums(&self) -> impl Iterator<Item = &Sums<F>> {
        self.nodes.iter().chain(&self.tail).map(|sums| &**sums)
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The data that it keeps of each pixel in addition to its sums.
    pub fn keeps(&self) -> Keeps {
        self.keeps
    }

    /// Indices of the samples that it has.
    pub fn range(&self) -> Range<u32> {
        self.range.clone()
    }

    /// Samples of every pixel.
    pub fn samples(&self) -> u32 {
        self.range.end - self.range.start
    }

    /// The layout of its samples.
    pub fn layout(&self) -> Layout {
        Layout::new(self.range())
    }

    /// The index up to which a film that continues this part from sample `done` accumulates before its sums are
    /// transferred, at most `to`: after each sample of the head, and at the end of each block.
    pub fn stop(&self, done: u32, to: u32) -> u32 {
        layout::stop(self.range.start, done, to)
    }

    /// Whether sums that end at `index` are complete.
    pub fn ends_at(&self, index: u32) -> bool {
        index > self.range.end && layout::ends_at(self.range.start, index)
    }

    /// Appends the sums of a film, which begin where this part ends and end at a [stop](Self::stop).
    pub fn close(&mut self, sums: Sums<F>) {
        let end = self.range.end + sums.samples;
        match layout::in_head(self.range.start, self.range.end) {
            true => {
                let values = sums.pixels.iter().map(|p| p.sum.sum).collect();
                self.head.push(Arc::new(values));
                self.range.end = end;
            }
            false => self.push(Arc::new(sums)),
        }
    }

    /// The same part with the sums of the incomplete block.
    pub fn with_tail(&self, sums: Sums<F>) -> Self {
        let mut part = self.clone();
        if sums.samples > 0 {
            part.range.end += sums.samples;
            part.tail = Some(Arc::new(sums));
        }
        part
    }

    /// The part without the incomplete block, and the sums of that block, if any.
    pub fn without_tail(mut self) -> (Self, Option<Arc<Sums<F>>>) {
        let tail = self.tail.take();
        self.range.end -= tail.as_ref().map_or(0, |tail| tail.samples);
        (self, tail)
    }

    /// Adds a node, and joins the last two as long as they are halves of a larger one.
    fn push(&mut self, node: Arc<Sums<F>>) {
        self.range.end += node.samples;
        self.nodes.push(node);
        while let [.., a, b] = &self.nodes[..]
            && layout::are_halves(self.range.end, a.samples, b.samples)
        {
            let b = self.nodes.pop();
            let a = self.nodes.pop();
            if let (Some(mut a), Some(b)) = (a, b) {
                Arc::make_mut(&mut a).join(&b);
                self.nodes.push(a);
            }
        }
    }
}

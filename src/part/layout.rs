//! The sums that a part keeps, which depend only on the indices of its samples.

use std::ops::Range;

use crate::film::Keeps;

/// Samples that are added one after the other. A power of two: small enough to store the individual values of one
/// block, where a part begins inside it; large enough not to shorten a GPU's dispatches.
pub const BLOCK: u32 = 256;

/// How the samples of a range are kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Samples stored individually.
    pub head: u32,
    /// Samples of each node, from left to right.
    pub nodes: Vec<u32>,
    /// Samples of the incomplete last block.
    pub tail: u32,
}

impl Layout {
    /// The layout for samples with these indices.
    pub fn new(range: Range<u32>) -> Self {
        let Range { start, end } = range;
        let head = first_block(start).min(end.max(start)) - start;
        let mut at = start + head;
        let mut nodes = Vec::new();
        while let Some(node) = largest(at, end) {
            nodes.push(node);
            at += node;
        }
        Self {
            head,
            nodes,
            tail: end.max(at) - at,
        }
    }
}

impl Layout {
    /// Samples of the nodes and of the tail, if any: those kept as sums.
    pub fn sums(&self) -> impl Iterator<Item = u32> {
        let tail = Some(self.tail).filter(|&tail| tail > 0);
        self.nodes.iter().copied().chain(tail)
    }

    /// Number of scalars per pixel; a value has three, sums have nine, moments twelve and quarters six.
    pub fn scalars(&self, keeps: Keeps) -> u64 {
        let sums = match keeps {
            Keeps::Nothing => 9,
            Keeps::Moments => 21,
            Keeps::Quarters => 15,
        };
        u64::from(self.head) * 3 + self.sums().count() as u64 * sums
    }
}

/// The samples of the largest node that begins at `at`, the start of a block, and ends by `end`.
fn largest(at: u32, end: u32) -> Option<u32> {
    let fits = end.saturating_sub(at) / BLOCK;
    let level = fits.checked_ilog2()?.min((at / BLOCK).trailing_zeros());
    Some(BLOCK << level)
}

/// The start of the first block at or after `begin`, or the last possible index.
fn first_block(begin: u32) -> u32 {
    begin.checked_next_multiple_of(BLOCK).unwrap_or(u32::MAX)
}

/// Whether the sample with index `index` of a part that begins at `begin` is stored individually.
pub fn in_head(begin: u32, index: u32) -> bool {
    index < first_block(begin)
}

/// See [`Part::stop`](super::Part::stop).
pub fn stop(begin: u32, done: u32, to: u32) -> u32 {
    match in_head(begin, done) {
        true => to.min(done + 1),
        false => to.min(done.saturating_add(BLOCK - done % BLOCK)),
    }
}

/// Whether the sums of a film that end at `index`, of a part that begins at `begin`, are complete.
pub fn ends_at(begin: u32, index: u32) -> bool {
    index.is_multiple_of(BLOCK) || index <= first_block(begin)
}

/// Whether two adjacent nodes with these numbers of samples, the second ending at `end`, form one node of the next
/// level.
pub fn are_halves(end: u32, a: u32, b: u32) -> bool {
    a == b && u64::from(end) % (2 * u64::from(b)) == 0
}

//! One sample of one pixel, as a renderer made it: the unit of comparison between renderers, path by path.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

/// The number of groups of a pixel's samples: the sample with index i is in group i mod `GROUPS`. The groups are
/// independent of each other, and the differences of their means give the error of the whole.
///
/// Two: each group has half the samples, which costs the low-discrepancy sequence some of its advantage. The error of a
/// picture is a mean over its pixels, each of which gives one number of noise: for 10,000 pixels, accurate to 1.4 %.
/// Four groups would give three numbers per pixel, 0.8 %, where fireflies leave 10 % uncertain; they would cost three
/// sums per pixel instead of one, and more of the sequence.
pub const GROUPS: u32 = 2;

/// The address of a sample. With the seed, it alone determines all random numbers of its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Address {
    /// Column and row, from the top left of the full picture.
    pub pixel: [u32; 2],
    pub index: u32,
}

/// The contribution and the decisions of its path; for a bidirectional sample, of both its paths, including splats on
/// other pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// W·sr⁻¹·m⁻²; for a renderer in f32 exactly its numbers, or their sum.
    pub radiance: [f64; 3],
    /// The hash of the path's decisions (`reference::integrator::path::signature`): equal for two paths with the same
    /// decisions.
    pub signature: u32,
}

/// The sample of a rendering with the brightest channel. If it is far above the mean, a few samples dominate the
/// picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Largest {
    pub address: Address,
    /// Its brightest channel, W·sr⁻¹·m⁻².
    pub radiance: f64,
}

impl Largest {
    /// The larger of two; among equals, the one whose pixel comes first, row by row.
    pub fn or(self, other: Self) -> Self {
        let place = |l: &Self| [l.address.pixel[1], l.address.pixel[0]];
        let order = self.radiance.total_cmp(&other.radiance);
        match order.then(place(&other).cmp(&place(&self))) {
            Ordering::Less => other,
            _ => self,
        }
    }
}

/// A sample as computed by the device and by both references.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairedSample {
    pub address: Address,
    pub device: Path,
    pub f32: Path,
    pub f64: Path,
}

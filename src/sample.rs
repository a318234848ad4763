//! One sample of one pixel, as a renderer made it: what renderers are compared by, path by path.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

/// Groups that the samples of a pixel fall into: the sample of index i into group i mod `GROUPS`. They are independent
/// of each other, and how far their means are apart tells the error of the whole.
///
/// Two: each group has half the samples, which is what a low-discrepancy sequence loses by being cut. The error of a
/// picture is a mean over its pixels, each of which tells one number of noise: of 10,000 pixels, to 1.4 %. Four groups
/// would tell three numbers a pixel, 0.8 %, where fireflies leave 10 % open; they would cost three sums a pixel
/// instead of one, and more of the sequence.
pub const GROUPS: u32 = 2;

/// Which sample it is. With the seed, all random numbers of its path depend on this alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Address {
    /// Column and row, from the top left of the full picture.
    pub pixel: [u32; 2],
    pub index: u32,
}

/// What its path brought, and how it went; of a bidirectional sample what both its paths brought, splats on other pixels among
/// it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// W·sr⁻¹·m⁻²; of a renderer in f32 exactly its numbers, or their sum.
    pub radiance: [f64; 3],
    /// The hash of the path's decisions (`reference::integrator::path::signature`): the same where two paths decided alike.
    pub signature: u32,
}

/// The sample of a rendering with the brightest channel. Where it is far above the mean, a few samples make the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Largest {
    pub address: Address,
    /// Its brightest channel, W·sr⁻¹·m⁻².
    pub radiance: f64,
}

impl Largest {
    /// The larger of two; of equals the one whose pixel comes first, row by row.
    pub fn or(self, other: Self) -> Self {
        let place = |l: &Self| [l.address.pixel[1], l.address.pixel[0]];
        let order = self.radiance.total_cmp(&other.radiance);
        match order.then(place(&other).cmp(&place(&self))) {
            Ordering::Less => other,
            _ => self,
        }
    }
}

/// A sample as the device and both references made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairedSample {
    pub address: Address,
    pub device: Path,
    pub f32: Path,
    pub f64: Path,
}

//! One sample of one pixel, as a renderer made it: what renderers are compared by, path by path.

/// Which sample it is. With the seed, all random numbers of its path depend on this alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// Column and row, from the top left of the full picture.
    pub pixel: [u32; 2],
    pub index: u32,
}

/// What its path brought, and how it went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// W·sr⁻¹·m⁻²; of a renderer in f32 exactly its numbers.
    pub radiance: [f64; 3],
    /// The hash of the path's decisions (`reference::path::signature`): the same where two paths decided alike.
    pub signature: u32,
}

/// A sample as the device and both references made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairedSample {
    pub address: Address,
    pub device: Path,
    pub f32: Path,
    pub f64: Path,
}

//! The random numbers of each path; twin of `shaders/path/blocks/`.

use crate::reference::sampler::LIGHT_PATH;

/// The end at which a path begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    Eye,
    Light,
}

/// The block of [`sampler::dimensions`](crate::reference::sampler::dimensions); for a light path, which shares no
/// number with the eye path of the same pixel and sample, one of its own.
pub fn path_block(from: Origin, block: u32) -> u32 {
    match from {
        Origin::Eye => block,
        Origin::Light => LIGHT_PATH + block,
    }
}

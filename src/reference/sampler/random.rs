//! Independent random numbers: a hash of where they are used.

use super::pcg4d::pcg4d;

/// Four words for one block of a path, `pixel` = row · width + column of the full picture.
pub fn sampler_block(pixel: u32, sample_index: u32, block: u32, seed: u32) -> [u32; 4] {
    pcg4d([pixel, sample_index, block, seed])
}

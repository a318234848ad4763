//! Scrambled Sobol points: the samples of a pixel are spread evenly, in two groups.

use super::sobol_groups::sobol_block;

/// Four words for one block of a path, `pixel` = row · width + column of the full picture.
pub fn sampler_block(pixel: u32, sample_index: u32, block: u32, seed: u32) -> [u32; 4] {
    // The groups are sample::GROUPS.
    sobol_block(pixel, sample_index, 1, block, seed)
}

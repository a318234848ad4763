//! Scrambled Sobol points in four groups: the quarters of the samples are independent pictures, by which a denoised one
//! is judged.

use super::sobol_groups::sobol_block;

/// Four words for one block of a path, `pixel` = row · width + column of the full picture.
pub fn sampler_block(pixel: u32, sample_index: u32, block: u32, seed: u32) -> [u32; 4] {
    sobol_block(pixel, sample_index, 2, block, seed)
}

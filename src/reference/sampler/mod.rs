//! Random numbers from integers alone, so that CPU and GPU draw the same; twin of `shaders/sampler/`.
//!
//! A sampler is a pure function `sampler_block(pixel, sample_index, block, seed)` to four words, one block of the
//! layout in [`dimensions`]. It has no state: a path may be interrupted anywhere and continued elsewhere.

mod chance;
pub mod dimensions;
pub mod owen;
pub mod pcg4d;
pub mod random;
pub mod sobol;
pub mod sobol_digits;
pub mod sobol_groups;
pub mod sobol_quarters;
#[cfg(test)]
mod tests;
mod unit_float;

use crate::settings::Sampler;
pub use chance::chance;
pub use dimensions::{LIGHT_PATH, bsdf_block, camera_block, light_block, roulette_block};
pub use unit_float::unit_float;

/// Four words for one block of a path from the chosen sampler, `pixel` = row · width + column of the full picture.
pub fn sampler_block(
    sampler: Sampler,
    pixel: u32,
    sample_index: u32,
    block: u32,
    seed: u32,
) -> [u32; 4] {
    match sampler {
        Sampler::Random => random::sampler_block(pixel, sample_index, block, seed),
        Sampler::Sobol => sobol::sampler_block(pixel, sample_index, block, seed),
        Sampler::SobolQuarters => sobol_quarters::sampler_block(pixel, sample_index, block, seed),
    }
}

//! Random numbers from integers alone, so that CPU and GPU draw the same; twin of `shaders/sampler/`.
//!
//! A sampler is a pure function `sampler_block(pixel, sample_index, block, seed)` to four words, one block
//! of the layout in [`dimensions`]. It keeps no state: a path may be cut anywhere and carried on elsewhere.
//! [`random`] is such a sampler; a quasi-random one (Owen-scrambled Sobol points, padded by four
//! dimensions at a time: the block decides the scrambling and the shuffle of `sample_index`) needs no more
//! than the same signature.

pub mod dimensions;
pub mod random;
#[cfg(test)]
mod tests;
mod unit_float;

pub use dimensions::{bsdf_block, camera_block, light_block, roulette_block};
pub use random::sampler_block;
pub use unit_float::unit_float;

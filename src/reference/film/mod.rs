//! Accumulation of samples; twin of `shaders/film/`.

pub mod pixel_sum;

pub use pixel_sum::{PixelSum, film_add, film_mean};

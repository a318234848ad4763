//! Accumulation of samples; twin of `shaders/film/`.

pub mod film_join;
pub mod film_moments;
pub mod film_pixel;
pub mod film_quarters;
pub mod pixel_sum;
#[cfg(test)]
mod tests;

pub use film_join::{film_join, film_join_contrast, film_join_moments, film_join_quarters};
pub use film_moments::{FilmMoments, film_moments, film_stderr};
pub use film_pixel::{FilmPixel, film_half_difference, film_sample};
pub use film_quarters::{FilmQuarters, film_quarters};
pub use pixel_sum::{PixelSum, film_add, film_mean, is_summable};

//! Scalars, vectors, frames and elementary functions; twin of `shaders/math/`.

pub mod elementary;
pub mod finite;
pub mod frame;
pub mod products;
pub mod real;
pub mod vec3;

pub use frame::Frame;
pub use products::difference_of_products;
pub use real::{Real, max2, min2};
pub use vec3::{Vec3, cross3, dot3, length3, max_component, mean3, normalize3, vec3};

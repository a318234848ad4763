//! Scalars, vectors, frames and elementary functions; twin of `shaders/math/`.

pub mod elementary;
pub mod finite;
pub mod frame;
pub mod lanes;
pub mod products;
pub mod real;
mod ulps;
pub mod vec;

pub use elementary::ErfcGauss;
pub use frame::Frame;
pub use products::difference_of_products;
pub use real::Real;
pub use ulps::ulps;
pub use vec::{Vec3, cross3, dot3, length3, max_component, max2, mean3, min2, normalize3, vec3};

//! Cameras; twin of `shaders/camera/`.

pub mod eye;
pub mod pinhole;

pub use eye::{EyeSample, eye_sample};
pub use pinhole::{Camera, camera_direction};

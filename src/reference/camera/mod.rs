//! Cameras; twin of `shaders/camera/`.

pub mod pinhole;

pub use pinhole::{Camera, camera_direction};

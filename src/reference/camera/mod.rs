//! Cameras; twin of `shaders/camera/`.

pub mod eye;
pub mod lens;
pub mod pinhole;

pub use eye::{EyeSample, eye_importance, eye_sample};
pub use lens::{Lens, camera_ray, eye_drawn};
pub use pinhole::{Camera, camera_direction};

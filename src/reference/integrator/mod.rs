//! Estimators of the picture, a folder each; twin of `shaders/integrator/`.
//!
//! [`path`](super::path) defines a path and how it travels; an integrator decides where paths begin, what they are
//! connected to, and which pixels they contribute to.

pub mod bidirectional;
pub mod layers;
pub mod light;
pub mod path;

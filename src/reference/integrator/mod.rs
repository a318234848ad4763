//! Estimators of the picture, a folder each; twin of `shaders/integrator/`.
//!
//! What a path is, and how it travels, stands in [`path`](super::path); an integrator decides where paths begin, what
//! they are connected to, and which pixels they bring light to.

pub mod bidirectional;
pub mod layers;
pub mod light;
pub mod path;

//! The CPU renderer: the truth that the kernels are held against, written once and generic over the scalar.
//!
//! Same folders, file, function and argument names as `shaders/`. Reads `prepared`, never the GPU's buffers.

pub mod accel;
pub mod bsdf;
pub mod camera;
pub mod film;
pub mod light;
pub mod math;
pub mod path;
pub mod sampler;
pub mod shape;
pub mod world;

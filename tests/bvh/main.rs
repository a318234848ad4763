//! The hierarchies, CPU and GPU, against brute force.

mod brute;
#[path = "../common/mod.rs"]
mod common;
mod cost;
mod cpu;
mod gpu;
#[path = "../common/icosphere.rs"]
mod icosphere;
mod random;
mod rays;
mod scenes;
mod tree;

//! The hierarchies, CPU and GPU, against brute force.

#[path = "../common/icosphere.rs"]
mod icosphere;
mod random;
mod scenes;
mod tree;

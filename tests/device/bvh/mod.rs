//! The hierarchies, CPU and GPU, against brute force.

mod brute;
mod cost;
mod cpu;
mod gpu;
mod random;
mod rays;
mod scenes;
mod tree;

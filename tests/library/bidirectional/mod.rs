//! Bidirectional path tracing: its weights by brute force, and its pictures against those of path tracing.

mod chain;
mod emission;
mod pictures;
mod stability;
mod weights;

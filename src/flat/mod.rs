//! From `prepared` to the kernels' buffers; each is asked for by the caller, which knows what a kernel needs.

pub mod bvh;

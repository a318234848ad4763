//! Tests of the library on a Vulkan device (see `common`).

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::unreachable,
    clippy::unwrap_used,
    reason = "a test fails by a panic, and may print what it measured"
)]

#[path = "../common/mod.rs"]
mod common;

mod bvh;
mod check;
mod classes;
mod closed_forms;
mod converge;
mod doctor;
mod explain;
mod f32_ends;
mod full_kernel;
mod gpu;
mod gpu_cache;
mod hand_over;
mod honest_error;
mod honest_stderr;
mod largest;
mod lens;
mod light_tracing;
mod oracle;
mod paired;
mod parts;
mod random_scenes;
mod same_bits;
mod scene_kernels;
mod several;
mod standard_errors;
mod surroundings;
mod trace;
mod twins;
mod while_rendering;

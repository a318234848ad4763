//! Tests of the library on the host alone: no device, no command line.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::unreachable,
    clippy::unwrap_used,
    reason = "a test fails by a panic, and may print what it measured"
)]

#[path = "../../fuzz/src/lib.rs"]
mod bodies;
#[path = "../common/mod.rs"]
mod common;

mod architecture;
mod best_device;
mod bidirectional;
mod bsdf;
mod caustic;
mod check_report;
mod citations;
mod classes;
mod coincident;
mod convergence_report;
mod corpus;
mod denoise;
mod energy;
mod estimators;
mod export;
mod farm;
mod icosphere;
mod image;
mod index_matched;
mod kernel;
mod kernel_layout;
mod layers;
mod lens;
mod light;
mod light_tracing;
mod links;
mod metrics;
mod needs;
mod no_allocation;
mod parts;
mod plain_words;
mod prepared;
mod report;
mod sampling;
mod scene;
mod shape;
mod slots;
mod state;
mod twin_names;
mod valid;
mod workflows;

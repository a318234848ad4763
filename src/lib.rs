//! vkpt: a headless path tracer on Vulkan compute, with a CPU reference that it equals bit for bit.

pub mod cache;
pub mod denoise;
pub mod features;
pub mod film;
pub mod flat;
pub mod gpu;
pub mod image;
pub mod kernel;
pub mod layout;
pub mod memory;
pub mod metrics;
pub mod part;
pub mod path_class;
pub mod prepared;
pub mod reference;
pub mod render;
pub mod report;
pub mod sample;
pub mod scene;
pub mod settings;
pub mod shape;
pub mod shell;
pub mod state;

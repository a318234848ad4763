//! Vulkan compute: devices, buffers, pipelines, dispatches; and Open Image Denoise ([`oidn`]). The only module with foreign
//! libraries, ash and `unsafe`.
//!
//! Everything is synchronous: a call returns when the device is done. Objects keep their device alive and free
//! themselves. A [`Device`] may be shared between threads; it does one piece of work at a time.

#![allow(
    unsafe_code,
    reason = "foreign libraries are called here, and nowhere else"
)]

mod barrier;
mod buffer;
mod device;
mod dispatch;
mod error;
mod facts;
mod info;
mod instance;
mod limits;
mod memory;
pub mod oidn;
mod options;
mod pipeline;
mod pipeline_cache;
mod probe;
mod queue;
mod selector;
mod shared_device;
mod statistics;
mod transfer;

pub use buffer::Buffer;
pub use device::Device;
pub use error::GpuError;
pub use facts::{Facts, FloatControls, Heap};
pub use info::{DeviceInfo, DeviceKind, devices};
pub use limits::Limits;
pub use options::Options;
pub use pipeline::Pipeline;
pub use selector::Selector;
pub use statistics::{Statistic, Value};

pub use crate::layout::BufferUse;

//! Rendering: a prepared scene, a device, and the film that comes out.

use std::sync::atomic::AtomicBool;

use crate::film::Film;
use crate::gpu::{Device, GpuError, Selector};
use crate::prepared::Prepared;
use crate::settings::Settings;

/// What renders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    Vulkan(Selector),
    CpuF32,
    CpuF64,
}

/// What is to be rendered.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    pub prepared: &'a Prepared,
    pub settings: Settings,
    /// Samples in every pixel, at most 2³² − 1.
    pub spp: u64,
    pub seed: u32,
    /// Left, top, right, bottom in pixels from the top left, right and bottom excluded; within the picture
    /// and not empty.
    pub crop: Option<[u32; 4]>,
}

/// How far a rendering is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Samples that every pixel has.
    pub samples_done: u64,
    pub spp: u64,
    /// Of all work, in [0, 1].
    pub fraction: f64,
}

/// Samples that count as 0, by cause.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dropped {
    pub nan: u64,
    pub infinite: u64,
    pub loops: u64,
}

/// A picture and how it came about.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub film: Film,
    /// Samples in every pixel.
    pub spp: u64,
    /// Stopped before all samples were there.
    pub interrupted: bool,
    pub stats: Stats,
}

/// What a rendering took.
#[derive(Clone, Debug, Default)]
pub struct Stats {
    pub device: String,
    pub driver: String,
    /// Seconds to compose the kernel.
    pub compose_s: f64,
    /// Seconds of the first dispatch, which is when drivers compile.
    pub compile_s: f64,
    /// Seconds of all other dispatches.
    pub render_s: f64,
    pub samples: u64,
    pub rays: u64,
    pub dropped: Dropped,
    pub long_paths: u64,
    /// What the kernel holds.
    pub features: Vec<String>,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    #[error(transparent)]
    Gpu(#[from] GpuError),
    #[error("not yet")]
    NotYet,
}

impl RenderError {
    /// Whether there is no such device, rather than one that failed.
    pub fn is_no_device(&self) -> bool {
        matches!(
            self,
            Self::Gpu(
                GpuError::NoVulkan(_) | GpuError::NoSuchDevice { .. } | GpuError::Unusable { .. }
            )
        )
    }
}

/// Renders the job, calling `progress` after each slice of samples. Once `stop` is set, finishes the sample
/// index under way in every pixel and returns what is there.
pub fn render(
    _job: &Job,
    target: &Target,
    _stop: &AtomicBool,
    _progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    if let Target::Vulkan(selector) = target {
        Device::open(selector)?;
    }
    Err(RenderError::NotYet)
}

/// The path of sample `index` of the pixel at column and row `pixel`, vertex by vertex, to be printed.
pub fn trace(
    _job: &Job,
    _target: &Target,
    _pixel: [u32; 2],
    _index: u32,
) -> Result<String, RenderError> {
    Err(RenderError::NotYet)
}

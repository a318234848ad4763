//! The record of a rendering; its JSON is `--json`'s file, field by field.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::SettingsRecord;

/// A rendering: the request, the machine, and the cost.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    pub version: Cow<'static, str>,
    #[serde(flatten)]
    pub job: Job,
    #[serde(flatten)]
    pub machine: Machine,
    pub seconds: Seconds,
    #[serde(flatten)]
    pub work: Work,
    /// The sample with the brightest channel; `None` if all are black.
    pub largest: Option<Largest>,
    /// After 1, 2, 4 … samples per pixel, and after the last.
    pub error: Vec<ErrorAt>,
    pub files: Vec<String>,
    /// The denoised picture next to it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub denoised: Option<Denoised>,
    pub warnings: Vec<String>,
}

/// A denoised picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Denoised {
    /// The denoiser.
    pub by: String,
    /// Seconds that it took.
    pub seconds: f64,
    /// Samples in every pixel of the half that is denoised and compared with quarters of the other.
    pub half_spp: u32,
    /// An unbiased estimate of that denoised half's relMSE, relative to itself; may be below 0.
    pub half_rel_mse: f64,
    /// Above it with 95 % confidence or more.
    pub half_rel_mse_upper: f64,
    pub files: Vec<String>,
}

/// Everything that the picture depends on, except the device.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Job {
    /// The scene file's path as it was given.
    pub scene: String,
    /// `--camera`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub camera: Option<String>,
    /// Width and height of the full picture.
    pub size: [u32; 2],
    /// Left, top, right, bottom in pixels of the full picture, right and bottom excluded.
    pub crop: Option<[u32; 4]>,
    /// For a part of a picture, the first index of its samples and the one after the last.
    pub range: Option<[u32; 2]>,
    /// Samples in every pixel: fewer than `spp_asked` if something else ended the rendering.
    pub spp: u32,
    pub spp_asked: u32,
    /// Why the rendering ended: `complete`, `interrupted`, `time` or `target-error`.
    pub ended: Cow<'static, str>,
    /// `--time`, seconds of rendering.
    pub time: Option<f64>,
    /// `--target-error`.
    pub target_error: Option<f64>,
    pub seed: u32,
    pub settings: SettingsRecord,
    /// Why `--integrator auto` chose the integrator of the settings.
    pub auto: Option<Cow<'static, str>>,
}

/// The machine.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Machine {
    pub device: String,
    /// Why it was chosen, as words after its name, if none was requested and there is no GPU.
    pub device_auto: Option<Cow<'static, str>>,
    pub driver: String,
    /// `None` for the reference, which has none.
    pub kernel: Option<Kernel>,
    pub memory: Memory,
}

/// The rendering kernel.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Kernel {
    /// `composed` or `full`.
    pub choice: Cow<'static, str>,
    /// Its parts.
    pub features: Vec<String>,
    pub spirv_bytes: u64,
}

/// Bytes.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Memory {
    /// All buffers on the device.
    pub device: u64,
    /// The peak memory of the process, if the system reports it.
    pub peak: Option<u64>,
}

/// Seconds by stage, on the wall clock.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Seconds {
    pub read: f64,
    pub prepare: f64,
    /// Opening the device.
    pub device: f64,
    /// Building the hierarchy, or the reference's tables.
    pub hierarchy: f64,
    /// From features to SPIR-V.
    pub compose: f64,
    /// Making and filling the buffers.
    pub upload: f64,
    /// The driver's part before the first dispatch.
    pub pipeline: f64,
    /// The first dispatch, which is when drivers compile.
    pub compile: f64,
    /// All other dispatches.
    pub render: f64,
    /// The device's own time for them, by its timestamps; `None` for the reference.
    pub gpu: Option<f64>,
    pub write: f64,
}

/// The picture's error estimate at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorAt {
    pub spp: u32,
    /// Of rendering so far, without compiling.
    pub seconds: f64,
    /// Estimate of the relMSE; `None` for one sample per pixel.
    pub rel_mse: Option<f64>,
    /// Its 95 % interval; `None` where none is reliable.
    pub low: Option<f64>,
    pub high: Option<f64>,
    /// If there is none: the number of pixels that make half of the error, and column and row of the worst.
    pub half_in_pixels: Option<usize>,
    pub worst_pixel: Option<[u32; 2]>,
}

/// A sample and its weight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Largest {
    /// Its brightest channel, W·sr⁻¹·m⁻².
    pub radiance: f64,
    /// That over the mean of the picture, all channels together. For similar samples it is about 1.
    pub weight: f64,
    /// Column and row in the full picture.
    pub pixel: [u32; 2],
    /// Its index among those of its pixel: `--trace` prints the path of X,Y,I.
    pub sample: u32,
}

/// The work done.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Work {
    pub samples: u64,
    pub rays: u64,
    /// Per second of all dispatches, the first included; `None` if no time was measured.
    pub samples_per_s: Option<f64>,
    pub rays_per_s: Option<f64>,
    pub dropped: Dropped,
    /// Paths of a thousand bounces or more, where roulette becomes unconditional.
    pub long_paths: u64,
    /// Paths that ended because scattering or absorption reduced their throughput below the range of f32, 2⁻¹²⁶.
    pub underflows: u64,
}

/// Samples that count as 0 because their value is invalid, by cause.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Dropped {
    pub nan: u64,
    pub infinite: u64,
    /// Ended by the driver inside a loop.
    #[serde(rename = "loop")]
    pub loops: u64,
}

impl Dropped {
    /// All causes together.
    pub fn total(&self) -> u64 {
        self.nan + self.infinite + self.loops
    }
}

impl Work {
    /// Counts, with their rates over the time that `seconds` gives to dispatches.
    pub fn new(
        seconds: &Seconds,
        samples: u64,
        rays: u64,
        dropped: Dropped,
        long_paths: u64,
        underflows: u64,
    ) -> Self {
        let time = seconds.compile + seconds.render;
        let rate = |count: u64| (time > 0.0).then(|| count as f64 / time);
        Self {
            samples,
            rays,
            samples_per_s: rate(samples),
            rays_per_s: rate(rays),
            dropped,
            long_paths,
            underflows,
        }
    }
}

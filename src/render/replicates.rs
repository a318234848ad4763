//! Renderings of one job with several seeds, each of which can be continued: a picture of n samples is the
//! beginning of that of 2n.

use std::sync::atomic::AtomicBool;

use super::{DispatchLimits, Job, RenderError, Target, cpu, memory, vulkan};
use crate::film::Film;
use crate::gpu::Device;
use crate::part::{AnyPart, Halves};

/// An open renderer.
pub enum Engine {
    Vulkan(Device, DispatchLimits),
    CpuF32,
    CpuF64,
}

/// Seconds of rendering.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Took {
    /// On the wall clock, with the host's work between dispatches.
    pub wall_s: f64,
    /// The device's own, by its timestamps; `None` for the reference.
    pub gpu_s: Option<f64>,
}

impl Took {
    /// Adds the seconds of further samples.
    pub fn add(&mut self, more: Self) {
        self.wall_s += more.wall_s;
        self.gpu_s = match (self.gpu_s, more.gpu_s) {
            (Some(a), Some(b)) => Some(a + b),
            (a, b) => a.or(b),
        };
    }
}

/// Films that grow.
pub(super) trait Growing {
    fn advance(&mut self, i: usize, spp: u32, stop: &AtomicBool) -> Result<Took, RenderError>;
    fn done(&self, i: usize) -> u32;
    fn part(&self, i: usize) -> AnyPart;
    fn set_up_s(&self) -> f64;
}

/// Independent renderings of a job, ready for their first sample: everything is compiled.
pub struct Replicates<'a>(Box<dyn Growing + 'a>);

impl Engine {
    /// Opens `target`.
    pub fn open(target: &Target) -> Result<Self, RenderError> {
        Ok(match target {
            Target::Vulkan(selector) => {
                let device = Device::open(selector)?;
                let limits = DispatchLimits::of(&device)?;
                Self::Vulkan(device, limits)
            }
            Target::CpuF32 => Self::CpuF32,
            Target::CpuF64 => Self::CpuF64,
        })
    }

    /// Name and driver.
    pub fn name(&self) -> [String; 2] {
        match self {
            Self::Vulkan(device, _) => [device.info().name.clone(), device.info().driver.clone()],
            Self::CpuF32 => ["cpu-f32".to_owned(), cpu::driver()],
            Self::CpuF64 => ["cpu-f64".to_owned(), cpu::driver()],
        }
    }
}

impl<'a> Replicates<'a> {
    /// One for each of `seeds`, which replace the job's; `spp` and `aovs` of the job are ignored.
    ///
    /// # Errors
    /// Those of a rendering, before and in its first dispatch.
    pub fn new(job: &'a Job<'a>, engine: &'a Engine, seeds: &[u32]) -> Result<Self, RenderError> {
        match engine {
            Engine::Vulkan(..) | Engine::CpuF32 => memory::check::<f32>(job, seeds.len())?,
            Engine::CpuF64 => memory::check::<f64>(job, seeds.len())?,
        }
        Ok(Self(match engine {
            Engine::Vulkan(device, limits) => vulkan::replicates(job, device, *limits, seeds)?,
            Engine::CpuF32 => cpu::replicates::<f32>(job, seeds),
            Engine::CpuF64 => cpu::replicates::<f64>(job, seeds),
        }))
    }

    /// Brings replicate `i` to `spp` samples per pixel; returns the time that the missing samples took. Once `stop` is
    /// set, the current sample index is the last.
    ///
    /// # Errors
    /// Those of a rendering. The replicate is then lost.
    pub fn advance(&mut self, i: usize, spp: u32, stop: &AtomicBool) -> Result<Took, RenderError> {
        self.0.advance(i, spp, stop)
    }

    /// Samples that each pixel of replicate `i` has.
    pub fn done(&self, i: usize) -> u32 {
        self.0.done(i)
    }

    /// The picture of replicate `i`: to the bit that of a rendering with its seed and as many samples.
    pub fn picture(&self, i: usize) -> Film {
        self.0.part(i).picture()
    }

    /// The means of the two groups of the samples of replicate `i`; for a single sample twice that sample.
    pub fn halves(&self, i: usize) -> [Film; 2] {
        let part = self.0.part(i);
        if part.samples() < 2 {
            return [part.picture(), part.picture()];
        }
        let Halves {
            mean,
            half_difference,
        } = part.halves();
        [1.0, -1.0].map(|sign| {
            let pixels = mean.rgb.iter().zip(&half_difference.rgb);
            let half = pixels.map(|(m, d)| [0, 1, 2].map(|c| m[c] + sign * d[c]));
            Film {
                rgb: half.collect(),
                ..mean
            }
        })
    }

    /// Seconds from the prepared scene to the first sample: hierarchy, composing, uploading and compiling.
    pub fn set_up_s(&self) -> f64 {
        self.0.set_up_s()
    }
}

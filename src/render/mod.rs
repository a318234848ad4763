//! Rendering: a prepared scene, a device, and the film that comes out.

mod best;
mod both;
mod course;
mod cpu;
mod follow;
mod host_film;
mod light_film;
mod memory;
mod paired;
mod pixels;
mod plan;
mod replicates;
mod several;
mod slices;
mod start;
mod tiles;
mod trace;
mod twice;
mod vulkan;

use std::sync::atomic::AtomicBool;

use crate::features::Features;
use crate::film::{Aov, Film};
pub use crate::gpu::Selector;
use crate::gpu::{Device, GpuError};
use crate::kernel::{KernelError, OwnFile, Spirv};
pub use crate::part::Dropped;
use crate::prepared::Prepared;
use crate::reference::path::SampleId;
use crate::sample::{Address, Largest};
use crate::settings::Settings;
pub use best::{Best, best, best_of};
pub use course::{End, ErrorAt, Until, look};
pub use follow::Watch;
pub use host_film::freedom;
use host_film::{HostFilm, empty_part, standard_errors};
use light_film::LightFilm;
pub use paired::paired;
use pixels::Pixels;
pub use plan::{ArrayPlan, HierarchyPlan, Plan, PlanLimits, StatePlan};
pub use replicates::{Engine, Replicates, Took};
pub use several::render_several;
pub use slices::WANTED as DISPATCH_TIME;
pub use start::{Start, State};
use tiles::Tile;
pub use trace::{Trace, chain, techniques, trace};
pub use vulkan::{DispatchLimits, statistics};

/// What renders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    Vulkan(Selector),
    CpuF32,
    CpuF64,
}

/// Which kernel renders on a Vulkan device. The picture does not depend on it, but for files of one's own; the reference
/// has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KernelChoice<'a> {
    /// What scene and settings need, and nothing else.
    #[default]
    Composed,
    /// What any scene could need: [`Features::full`].
    Full,
    /// These features, which must hold what scene and settings need.
    Given(&'a Features),
    /// What scene and settings need, with files of one's own in place of some of `shaders/`: another estimator, say,
    /// to be measured beside vkpt's by [`converge`](crate::converge). [`file`](crate::kernel::file) has vkpt's text. A
    /// file that the kernel does not use is an error.
    Own(&'a [OwnFile<'a>]),
}

/// What is to be rendered.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    pub prepared: &'a Prepared,
    pub settings: Settings,
    /// Samples in every pixel; of a part of them ([`Start::At`]) the index that they end before.
    pub spp: u32,
    /// When to end before all of them are there.
    pub until: Until,
    pub seed: u32,
    /// Left, top, right, bottom in pixels from the top left, right and bottom excluded; within the picture
    /// and not empty.
    pub crop: Option<[u32; 4]>,
    /// What to make beside the picture, which it does not change.
    pub aovs: &'a [Aov],
    pub kernel: KernelChoice<'a>,
}

impl Job<'_> {
    /// What the kernel of this job holds.
    pub fn features(&self) -> Features {
        match self.kernel {
            KernelChoice::Composed | KernelChoice::Own(_) => {
                Features::of(self.prepared, &self.settings, self.aovs)
            }
            KernelChoice::Full => Features::full(&self.settings, self.aovs),
            KernelChoice::Given(features) => features.clone(),
        }
    }

    /// What stands in place of shader files of vkpt's.
    fn own_files(&self) -> &[OwnFile<'_>] {
        match self.kernel {
            KernelChoice::Own(files) => files,
            _ => &[],
        }
    }

    /// Width and height of the picture, or of its crop.
    pub fn size(&self) -> [u32; 2] {
        [self.area().width, self.area().height]
    }

    /// A sample of this rendering.
    fn sample(
        &self,
        Address {
            pixel: [column, row],
            index,
        }: Address,
    ) -> SampleId {
        SampleId {
            column,
            row,
            pixel: row * self.prepared.camera.width + column,
            sample: index,
            seed: self.seed,
        }
    }

    /// All pixels of the picture.
    fn whole(&self) -> Tile {
        Tile {
            x: 0,
            y: 0,
            width: self.prepared.camera.width,
            height: self.prepared.camera.height,
        }
    }

    /// The pixels to be rendered.
    fn area(&self) -> Tile {
        let [left, top, right, bottom] = self.crop.unwrap_or([
            0,
            0,
            self.prepared.camera.width,
            self.prepared.camera.height,
        ]);
        Tile {
            x: left,
            y: top,
            width: right - left,
            height: bottom - top,
        }
    }
}

/// How far a rendering is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Samples that every pixel has.
    pub samples_done: u32,
    /// The most that it will have.
    pub spp: u32,
    /// Of all work, in [0, 1]: by samples, by time or by error, whichever it is to end at.
    pub fraction: f64,
}

/// A picture and how it came about.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub film: Film,
    /// Standard error of the mean per pixel and channel: if [`Aov::Stderr`] was asked for and there are two samples. Its
    /// square is unbiased and has as many degrees of freedom as [`freedom`] says.
    pub stderr: Option<Film>,
    /// Samples in every pixel.
    pub spp: u32,
    pub end: End,
    /// Why the device failed the second time, of [`End::Lost`].
    pub failure: Option<String>,
    /// What can be gone on from. Its errors are what is known of the picture's error after 1, 2, 4 … samples, and after the
    /// last.
    pub state: State,
    pub stats: Stats,
}

impl Outcome {
    /// The picture of a state, and what `stats` lacks of how it came about.
    fn new(job: &Job, state: State, end: End, stats: Stats) -> Self {
        let part = &state.part;
        let (spp, tally) = (part.samples(), part.tally());
        Self {
            film: part.picture(),
            stderr: standard_errors(job, part),
            spp,
            end,
            failure: None,
            stats: Stats {
                render_s: state.seconds,
                samples: u64::from(spp) * u64::from(job.area().pixels()),
                rays: tally.counts.rays,
                dropped: tally.counts.dropped,
                long_paths: tally.counts.long_paths,
                underflows: tally.counts.underflows,
                largest: tally.largest,
                ..stats
            },
            state,
        }
    }
}

/// Seconds from a prepared scene to the first dispatch, by stage.
#[derive(Clone, Copy, Debug, Default)]
pub struct SetUp {
    /// To open the device; 0 where it was open.
    pub device: f64,
    /// To build the hierarchy; for the reference, all of its tables.
    pub hierarchy: f64,
    /// From features to a module of SPIR-V.
    pub compose: f64,
    /// To make the buffers and fill them.
    pub upload: f64,
    /// What the driver does of its compiling before the first dispatch.
    pub pipeline: f64,
}

/// What a rendering took.
#[derive(Clone, Debug, Default)]
pub struct Stats {
    pub device: String,
    pub driver: String,
    /// How the device rounds: two that agree in this make the same bits. [`NEAREST`], or a name of its own.
    pub rounding: String,
    pub set_up: SetUp,
    /// Seconds of the first dispatch, which is when drivers compile.
    pub compile_s: f64,
    /// Seconds of all other dispatches, with all that the host does between them.
    pub render_s: f64,
    /// The device's own seconds for them, by its timestamps; `None` for the reference.
    pub gpu_s: Option<f64>,
    pub samples: u64,
    pub rays: u64,
    pub dropped: Dropped,
    pub long_paths: u64,
    pub underflows: u64,
    /// The sample with the brightest channel; `None` where all are black.
    pub largest: Option<Largest>,
    /// What the kernel holds.
    pub features: Vec<String>,
    /// Size of the kernel's module; 0 for the reference, which has none.
    pub spirv_bytes: u64,
    /// Names and bytes of the buffers on the device, in the order of their bindings.
    pub buffers: Vec<(String, u64)>,
}

/// How the reference rounds, and with it the Vulkan drivers of CPUs.
pub const NEAREST: &str = "to nearest";

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    #[error(transparent)]
    Gpu(#[from] GpuError),
    #[error(
        "the kernel of this scene does not compile, which is a mistake of vkpt's or in a shader file given to it:\n{error}\n\
         It was to hold {features}"
    )]
    Kernel {
        #[source]
        error: KernelError,
        features: Box<Features>,
    },
    #[error(
        "the driver ended loops of {0} paths before their end: the picture would be wrong. \
         Try another driver, or --device cpu-f32"
    )]
    Loops(u64),
    #[error(
        "the films of the picture take {:.1} GiB of memory, and {:.1} GiB are free: --size or --crop make them smaller",
        gib(*.needed), gib(*.free)
    )]
    Memory { needed: u64, free: u64 },
    #[error(
        "what was rendered before is of another size, of another scalar, or lacks what standard errors are made from"
    )]
    Start,
    #[error("the device failed twice: {0}")]
    Twice(Box<RenderError>),
}

fn gib(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 30)
}

impl RenderError {
    /// Whether a device opened anew may succeed.
    fn is_loss(&self) -> bool {
        matches!(self, Self::Gpu(error) if error.is_loss())
    }

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

/// Renders the job, calling `progress` after each slice of samples. Once `stop` is set, or what the job is to end at
/// is reached, finishes the sample index under way in every pixel and returns what is there: the same, to the bit, as
/// of a job of so many samples.
pub fn render(
    job: &Job,
    target: &Target,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    render_from(job, target, &Start::At(0), stop, &mut |p| progress(p))
}

/// Renders as [`render`] does, from `start` on. A device that fails is opened anew, once; if it fails again, what is there
/// by then comes out, if every pixel has a sample.
pub fn render_from(
    job: &Job,
    target: &Target,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    match target {
        Target::Vulkan(selector) => {
            memory::check::<f32>(job, 1)?;
            twice::render(job, selector, start, stop, watch)
        }
        Target::CpuF32 => {
            memory::check::<f32>(job, 1)?;
            cpu::render::<f32>(job, "cpu-f32", start, stop, watch)
        }
        Target::CpuF64 => {
            memory::check::<f64>(job, 1)?;
            cpu::render::<f64>(job, "cpu-f64", start, stop, watch)
        }
    }
}

/// Renders as [`render`] does, on a device that is open already; `limits` have no influence on the picture.
pub fn render_on(
    job: &Job,
    device: &Device,
    limits: DispatchLimits,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, RenderError> {
    let start = Start::At(0);
    let rendered = vulkan::render(job, device, limits, &start, stop, &mut |p| progress(p));
    rendered.map_err(|failed| failed.error)
}

/// The kernels that render the job on `device`, composed and compiled for its scene and settings.
pub fn kernels(job: &Job, device: &Device) -> Result<Vec<Spirv>, RenderError> {
    Plan::new(job, PlanLimits::of(device))?.compile()
}

//! The outcome of a rendering.

use super::course::End;
use super::host_film::standard_errors;
use super::job::Job;
use super::start::State;
use crate::film::Film;
use crate::part::Dropped;
use crate::sample::Largest;

/// The progress of a rendering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Samples that every pixel has.
    pub samples_done: u32,
    /// The most that it will have.
    pub spp: u32,
    /// Share of all work, in [0, 1]: by samples, by time or by error, according to its limit.
    pub fraction: f64,
}

/// A picture and the record of its making.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub film: Film,
    /// Standard error of the mean per pixel and channel: if `Aov::Stderr` was requested and there are at least two
    /// samples. Its square is unbiased and has the degrees of freedom of the part ([`crate::part::AnyPart::freedom`]).
    pub stderr: Option<Film>,
    /// Samples in every pixel.
    pub spp: u32,
    pub end: End,
    /// Why the device failed the second time, with [`End::Lost`].
    pub failure: Option<String>,
    /// The state from which to continue. Its errors are the estimates of the picture's error after 1, 2, 4 … samples,
    /// and after the last.
    pub state: State,
    pub stats: Stats,
}

impl Outcome {
    /// The picture of a state, with its statistics.
    pub(super) fn new(job: &Job, state: State, end: End, stats: Stats) -> Self {
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
    /// To open the device; 0 if it was open.
    pub device: f64,
    /// To build the hierarchy; for the reference, all of its tables.
    pub hierarchy: f64,
    /// From features to a module of SPIR-V.
    pub compose: f64,
    /// To make the buffers and fill them.
    pub upload: f64,
    /// The part of the driver's compiling that it does before the first dispatch.
    pub pipeline: f64,
}

/// Statistics of a rendering.
#[derive(Clone, Debug, Default)]
pub struct Stats {
    pub device: String,
    pub driver: String,
    /// How the device rounds: two with the same entry make the same bits. [`NEAREST`], or a unique name.
    pub rounding: String,
    pub set_up: SetUp,
    /// Seconds of the first dispatch, which is when drivers compile.
    pub compile_s: f64,
    /// Seconds of all other dispatches, with the host's work between them.
    pub render_s: f64,
    /// The device's own seconds for them, by its timestamps; `None` for the reference.
    pub gpu_s: Option<f64>,
    pub samples: u64,
    pub rays: u64,
    pub dropped: Dropped,
    pub long_paths: u64,
    pub underflows: u64,
    /// The sample with the brightest channel; `None` if all are black.
    pub largest: Option<Largest>,
    /// The features of the kernel.
    pub features: Vec<String>,
    /// Size of the kernel's module; 0 for the reference, which has none.
    pub spirv_bytes: u64,
    /// Names and bytes of the buffers on the device, in the order of their bindings.
    pub buffers: Vec<(String, u64)>,
}

/// The rounding of the reference and of the Vulkan drivers of CPUs.
pub const NEAREST: &str = "to nearest";

//! The fastest device for a job that names none.

use super::{Job, Target};
use crate::gpu::{self, DeviceInfo, DeviceKind, Selector};
use crate::prepared::ShapeKind;
use crate::settings::Integrator;

/// A device, and the reason for its choice, as words after its name; `None` if it is the one best Vulkan device, a GPU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Best {
    pub target: Target,
    pub why: Option<&'static str>,
}

/// Measurements of CPU driver and reference in scenes of few primitives.
struct Measured {
    /// Samples a second and thread of the reference; scenes differ from it by a factor of up to 2.
    rate: f64,
    /// A CPU's Vulkan driver pays off in renderings that take the reference longer than this many seconds. With paths
    /// from the eye it is two to four times as fast and compiles for .5 (Mesa 22) to 4 seconds (Mesa 25); with paths of
    /// light it is 1.2 times as fast, and compiles two kernels.
    worth: f64,
}

/// With at most this many primitives in its hierarchy a CPU driver is still faster: 1.4 times with 48, .7 with 570.
const FEW_SEARCHED: usize = 64;

const EYE: Measured = Measured {
    rate: 5e5,
    worth: 5.0,
};
const LIGHT: Measured = Measured {
    rate: 2e5,
    worth: 60.0,
};

/// The best device of this machine: a GPU if it has one. Otherwise a CPU driver and the reference give the same bits,
/// and a rule says which is faster (`docs/records/2026-11-29-best-device.md`).
pub fn best(job: &Job) -> Best {
    let usable = |d: DeviceInfo| d.unusable.is_none().then_some(d.kind);
    let kinds = gpu::devices().map(|all| all.into_iter().filter_map(usable).collect());
    // Without a loader or a driver the list is empty.
    let kinds: Vec<DeviceKind> = kinds.unwrap_or_default();
    best_of(job, &kinds, rayon::current_num_threads())
}

/// The best among usable Vulkan devices of these kinds, and the reference on this many threads.
pub fn best_of(job: &Job, kinds: &[DeviceKind], threads: usize) -> Best {
    let vulkan = |why| Best {
        target: Target::Vulkan(Selector::Best),
        why,
    };
    let reference = |why| Best {
        target: Target::CpuF32,
        why: Some(why),
    };
    let measured = match job.settings.estimator.integrator {
        Integrator::Path => EYE,
        Integrator::Light | Integrator::Bidirectional => LIGHT,
    };
    let seconds = reference_seconds(job, measured.rate * threads as f64);
    match () {
        () if kinds.iter().any(|&kind| kind != DeviceKind::Cpu) => vulkan(None),
        () if kinds.is_empty() => reference("as no Vulkan device is usable"),
        () if searched(job) > FEW_SEARCHED => reference("which is faster for this many primitives"),
        () if seconds < measured.worth => reference("which needs no compilation"),
        () => vulkan(Some("worth compiling for this many samples")),
    }
}

/// Primitives that the kernel searches in its hierarchy.
fn searched(job: &Job) -> usize {
    let count = |&kind: &ShapeKind| job.prepared.primitives.count(kind);
    job.features().in_bvh.iter().map(count).sum()
}

/// Roughly how long the reference takes at this many samples a second; until an error is reached, long.
fn reference_seconds(job: &Job, rate: f64) -> f64 {
    let [width, height] = job.size();
    let all = f64::from(width) * f64::from(height) * f64::from(job.spp) / rate;
    job.until.seconds.map_or(all, |limit| all.min(limit))
}

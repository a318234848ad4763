//! What a rendering did, put on record.

use super::arguments::RenderArguments;
use crate::cli::exit::Failure;
use crate::cli::job::Ready;
use crate::memory::peak;
use crate::render::{self, Best, End, Outcome, Stats, Target};
use crate::report::names::Named;
use crate::report::{
    Dropped, ErrorAt, Job, Kernel, Largest, Machine, Memory, Record, Seconds, Work,
};

pub fn record(
    arguments: &RenderArguments,
    ready: &Ready,
    best: &Best,
    outcome: &Outcome,
) -> Result<Record, Failure> {
    let stats = &outcome.stats;
    let seconds = Seconds {
        read: ready.read_s,
        prepare: ready.prepare_s,
        device: stats.set_up.device,
        hierarchy: stats.set_up.hierarchy,
        compose: stats.set_up.compose,
        upload: stats.set_up.upload,
        pipeline: stats.set_up.pipeline,
        compile: stats.compile_s,
        render: stats.render_s,
        gpu: stats.gpu_s,
        write: 0.0,
    };
    let render::Dropped {
        nan,
        infinite,
        loops,
    } = stats.dropped;
    let dropped = Dropped {
        nan,
        infinite,
        loops,
    };
    Ok(Record {
        version: env!("CARGO_PKG_VERSION"),
        job: Job {
            scene: arguments.scene()?.name(),
            size: [ready.prepared.camera.width, ready.prepared.camera.height],
            crop: arguments.view.crop,
            spp: outcome.spp,
            spp_asked: arguments.spp(),
            ended: match outcome.end {
                End::Complete => "complete",
                End::Interrupted => "interrupted",
                End::Time => "time",
                End::Error => "target-error",
            },
            time: arguments.time,
            target_error: arguments.target_error,
            seed: arguments.seed,
            settings: (&ready.settings).into(),
            auto: ready.why,
        },
        machine: Machine {
            device: stats.device.clone(),
            driver: stats.driver.clone(),
            device_auto: best.why,
            kernel: kernel(arguments, &best.target, stats),
            memory: Memory {
                device: stats.buffers.iter().map(|b| b.1).sum(),
                peak: peak(),
            },
        },
        work: Work::new(
            &seconds,
            stats.samples,
            stats.rays,
            dropped,
            stats.long_paths,
            stats.underflows,
        ),
        seconds,
        largest: largest(outcome),
        error: outcome.errors.iter().map(error).collect(),
        files: Vec::new(),
        warnings: ready.warnings.clone(),
    })
}

fn error(at: &render::ErrorAt) -> ErrorAt {
    let interval = at.rel_mse.and_then(|e| e.interval.ok());
    let culprits = at.rel_mse.and_then(|e| e.interval.err());
    ErrorAt {
        spp: at.spp,
        seconds: at.seconds,
        rel_mse: at.rel_mse.map(|e| e.estimate),
        low: interval.map(|[low, _]| low),
        high: interval.map(|[_, high]| high),
        half_in_pixels: culprits.map(|c| c.half),
        worst_pixel: culprits.map(|c| c.worst),
    }
}

fn largest(outcome: &Outcome) -> Option<Largest> {
    let of = outcome.stats.largest?;
    let values = outcome.film.rgb.as_flattened();
    let mean = values.iter().map(|&x| f64::from(x)).sum::<f64>() / values.len() as f64;
    Some(Largest {
        radiance: of.radiance,
        weight: of.radiance / mean,
        pixel: of.address.pixel,
        sample: of.address.index,
    })
}

/// The kernel of a Vulkan device; the reference has none.
fn kernel(arguments: &RenderArguments, target: &Target, stats: &Stats) -> Option<Kernel> {
    matches!(target, Target::Vulkan(_)).then(|| Kernel {
        choice: arguments.kernel.name(),
        features: stats.features.clone(),
        spirv_bytes: stats.spirv_bytes,
    })
}

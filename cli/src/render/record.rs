//! The record of a rendering.

use super::arguments::RenderArguments;
use vkpt::film::Film;
use vkpt::memory::peak;
use vkpt::metrics::noise::{Culprits, RelMse};
use vkpt::render::{self, Best, End, Outcome, Stats, Target};
use vkpt::report::names::Named;
use vkpt::report::{
    Dropped, ErrorAt, Job, Kernel, Largest, Machine, Memory, Record, Seconds, Work,
};
use vkpt::sample;
use vkpt_lab::cli::job::Ready;
use vkpt_lab::cli::source::Source;

/// The record of a rendering; before it starts, without the results.
pub fn record(
    arguments: &RenderArguments,
    ready: &Ready,
    best: &Best,
    outcome: Option<&Outcome>,
) -> Record {
    let none = Stats::default();
    let stats = outcome.map_or(&none, |o| &o.stats);
    let seconds = seconds(ready, stats);
    let errors = outcome.map_or(&[][..], |o| &o.state.errors);
    Record {
        version: env!("CARGO_PKG_VERSION").into(),
        job: job(arguments, ready, outcome),
        machine: Machine {
            device: stats.device.clone(),
            driver: stats.driver.clone(),
            device_auto: best.why.map(Into::into),
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
            dropped(stats.dropped),
            stats.long_paths,
            stats.underflows,
        ),
        seconds,
        largest: outcome.and_then(|o| largest(&o.film, o.stats.largest)),
        error: errors.iter().map(error).collect(),
        files: Vec::new(),
        denoised: None,
        warnings: ready.warnings.clone(),
    }
}

fn job(arguments: &RenderArguments, ready: &Ready, outcome: Option<&Outcome>) -> Job {
    let range = outcome.map(|o| o.state.part.range());
    let ended = outcome.map_or(End::Interrupted, |o| o.end);
    Job {
        scene: arguments.scene.as_ref().map_or(String::new(), Source::name),
        camera: arguments.view.camera.clone(),
        size: [ready.prepared.camera.width, ready.prepared.camera.height],
        crop: arguments.view.crop,
        range: range
            .filter(|_| arguments.samples.is_some())
            .map(|range| [range.start, range.end]),
        spp: outcome.map_or(0, |o| o.spp),
        spp_asked: arguments.range().len() as u32,
        ended: match ended {
            End::Complete => "complete",
            End::Interrupted => "interrupted",
            End::Time => "time",
            End::Error => "target-error",
            End::Lost => "device-lost",
        }
        .into(),
        time: arguments.time,
        target_error: arguments.target_error,
        seed: arguments.seed,
        settings: (&ready.settings).into(),
        auto: ready.why.map(Into::into),
    }
}

fn seconds(ready: &Ready, stats: &Stats) -> Seconds {
    Seconds {
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
    }
}

/// The error at one time, for the record.
pub fn error(at: &render::ErrorAt) -> ErrorAt {
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

/// The same from the record.
pub fn error_of(at: &ErrorAt) -> render::ErrorAt {
    let ends = at.low.zip(at.high).map(|(low, high)| [low, high]);
    let culprits = Culprits {
        half: at.half_in_pixels.unwrap_or(0),
        worst: at.worst_pixel.unwrap_or_default(),
    };
    render::ErrorAt {
        spp: at.spp,
        seconds: at.seconds,
        rel_mse: at.rel_mse.map(|estimate| RelMse {
            estimate,
            interval: ends.ok_or(culprits),
        }),
    }
}

/// The sample with the brightest channel, for the record.
pub fn largest(film: &Film, largest: Option<sample::Largest>) -> Option<Largest> {
    let of = largest?;
    let values = film.rgb.as_flattened();
    let mean = values.iter().map(|&x| f64::from(x)).sum::<f64>() / values.len() as f64;
    let weight = of.radiance / mean;
    weight.is_finite().then_some(Largest {
        radiance: of.radiance,
        weight,
        pixel: of.address.pixel,
        sample: of.address.index,
    })
}

/// Samples that count as 0, for the record.
pub fn dropped(of: render::Dropped) -> Dropped {
    Dropped {
        nan: of.nan,
        infinite: of.infinite,
        loops: of.loops,
    }
}

/// The kernel of a Vulkan device; the reference has none.
fn kernel(arguments: &RenderArguments, target: &Target, stats: &Stats) -> Option<Kernel> {
    matches!(target, Target::Vulkan(_)).then(|| Kernel {
        choice: arguments.kernel.name().into(),
        features: stats.features.clone(),
        spirv_bytes: stats.spirv_bytes,
    })
}

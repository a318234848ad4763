//! `vkpt compare --paired SCENE`: the same paths by three renderers.

mod findings;
mod table;

use self::findings::{Findings, PAIRS};
use super::arguments::PairedArguments;
use crate::cli::command;
use crate::cli::destination::all_written;
use crate::cli::exit::{Ending, Failure, warn};
use crate::cli::integrator::needs_eye_paths;
use crate::cli::interrupt::stop_flag;
use crate::cli::job::Ready;
use crate::cli::progress::Display;
use crate::cli::streams::put;
use vkpt::gpu::{Device, DeviceKind};
use vkpt::metrics::paired::Comparison;
use vkpt::render::{self, Job, Target};
use vkpt::report::human::plural;

/// Compares the Vulkan device, cpu-f32 and cpu-f64 path by path, and prints a table.
pub fn paired(arguments: &PairedArguments) -> Result<Ending, Failure> {
    let request = arguments
        .request()
        .ok_or_else(|| Failure::Usage("a scene file is missing".to_owned()))?;
    needs_eye_paths(&request.settings, "--paired")?;
    let ready = Ready::new(&request)?;
    let job = ready.job(&request)?;
    let device = Device::open(&arguments.device()).map_err(|e| Failure::Render(e.into()))?;
    let (pairs, interrupted) = compare(&job, &device, arguments.quiet)?;
    let findings = Findings {
        pairs,
        correctly_rounded: device.info().kind == DeviceKind::Cpu,
        show: [Target::Vulkan(arguments.device().clone()), Target::CpuF64]
            .map(|target| command::show(&request, &target)),
    };
    if !arguments.quiet {
        let text = head(&request.scene.name(), &job, &device) + &table::text(&findings);
        all_written([put(text.as_bytes())])?;
    }
    match findings.failures() {
        _ if interrupted => {
            warn("interrupted: the remaining paths were not compared");
            Ok(Ending::Interrupted)
        }
        failures if failures.is_empty() => Ok(Ending::Complete),
        failures => Err(Failure::Comparison(failures)),
    }
}

/// The comparison of each pair, and whether ctrl-c interrupted it.
fn compare(
    job: &Job,
    device: &Device,
    quiet: bool,
) -> Result<([Comparison; PAIRS.len()], bool), Failure> {
    let mut pairs: [Comparison; PAIRS.len()] = Default::default();
    let stop = stop_flag();
    let mut display = Display::new(quiet);
    let ended = render::paired(job, device, &stop, &mut |p| display.update(p), &mut |s| {
        let of = [(&s.device, &s.f32), (&s.device, &s.f64), (&s.f32, &s.f64)];
        for (pair, (a, b)) in pairs.iter_mut().zip(of) {
            pair.add(s.address, a, b);
        }
    });
    display.finish();
    Ok((pairs, ended.map_err(Failure::Render)?))
}

/// The heading: scene, rendering and device.
fn head(scene: &str, job: &Job, device: &Device) -> String {
    let (width, height) = (job.prepared.camera.width, job.prepared.camera.height);
    let info = device.info();
    format!(
        "{scene}: {width}×{height}, {} per pixel, seed {}\nGPU: {}, {}\n\n",
        plural(job.spp.into(), "sample"),
        job.seed,
        info.name,
        info.driver
    )
}

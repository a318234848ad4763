//! `vkpt explain SCENE`: the kernel and buffers of a rendering, and the reasons for them, without rendering.

mod arguments;
mod outputs;

use crate::cli::beside::split;
use crate::cli::console::Console;
use crate::cli::destination::{Destination, all_written};
use crate::cli::exit::{Ending, Failure};
use crate::cli::inputs::Input;
use crate::cli::job::Loaded;
use crate::cli::writable;
use crate::explain::report::{Count, page};
use crate::explain::{Preset, Subject, explain as explanation};
pub use arguments::ExplainArguments;
use vkpt::gpu::{Device, Options, Selector, Statistic};
use vkpt::kernel::{Composed, Spirv};
use vkpt::render::{Job, KernelChoice, Plan, PlanLimits, statistics};
use vkpt::settings::Integrator;

/// Prints the page, or the kernel's GLSL; writes its SPIR-V if requested.
pub fn explain(arguments: &ExplainArguments) -> Result<Ending, Failure> {
    // Reports unwritable files before the work starts; files are claimed below, with those next to them.
    drop(writable::check(&arguments.spirv)?);
    let spirv_on_stdout = arguments.spirv.as_ref().is_some_and(Destination::is_stdout);
    if arguments.glsl && spirv_on_stdout {
        return Err(Failure::Usage(
            "--glsl and --spirv - would both be written to stdout".to_owned(),
        ));
    }
    let request = arguments.request();
    let loaded = Loaded::new(&request)?;
    let ready = loaded.prepare(&request)?;
    let (aovs, classes) = split(&arguments.aov);
    let job = Job {
        aovs: &aovs,
        classes: &classes,
        kernel: arguments.kernel,
        ..ready.job(&request)?
    };
    let device = device(arguments)?;
    let limits = device
        .as_ref()
        .map_or(PlanLimits::default(), PlanLimits::of);
    let plan = Plan::new(&job, limits).map_err(Failure::Render)?;
    let inputs = Input::of_scene(request.scene, &loaded.scene);
    let (files, _claims) = outputs::check(arguments, plan.kernels.len(), &inputs)?;
    let spirv = plan.compile().map_err(Failure::Render)?;
    let text = if arguments.glsl {
        plan.kernels.iter().map(Composed::by_file).collect()
    } else {
        let full = Job {
            kernel: KernelChoice::Full,
            ..job
        };
        let full = Plan::new(&full, limits).map_err(Failure::Render)?;
        let full_spirv = full.compile().map_err(Failure::Render)?;
        let counting = device.as_ref().filter(|_| arguments.statistics);
        let counts = counting
            .map(|device| counts(&plan, &spirv, device))
            .transpose()?;
        let name = device.as_ref().map_or(NO_DEVICE, |d| &d.info().name);
        let subject = Subject {
            job: &job,
            plan: &plan,
            scene: &arguments.scene.name(),
            text: &loaded.text,
            preset: preset(arguments),
            auto: ready.why,
            device: name,
        };
        page(&explanation(&subject, &spirv, (&full, &full_spirv), counts))
    };
    let written = outputs::write(&files, &spirv);
    let printed = Console::beside(&files).print(&text);
    all_written(written.into_iter().chain([printed]))?;
    Ok(Ending::Complete)
}

/// The source of the limits if no device is available.
const NO_DEVICE: &str = "those of most GPUs (no Vulkan device found)";

/// The requested device, else the best; if none is available, the kernel is explained without one.
fn device(arguments: &ExplainArguments) -> Result<Option<Device>, Failure> {
    let options = Options {
        statistics: arguments.statistics,
        ..Options::from_env()
    };
    let selector = arguments.device.as_ref().unwrap_or(&Selector::Best);
    match Device::open_with(selector, options) {
        Ok(device) => Ok(Some(device)),
        Err(_) if arguments.device.is_none() && !arguments.statistics => Ok(None),
        Err(error) => Err(Failure::Render(error.into())),
    }
}

/// The driver's statistics of the kernels.
fn counts(plan: &Plan, spirv: &[Spirv], device: &Device) -> Result<Vec<Count>, Failure> {
    let names: &[&str] = match plan.features.integrator {
        Integrator::Bidirectional => &["light paths", "eye paths"],
        Integrator::Path | Integrator::Light => &[""],
    };
    let of_kernels = statistics(plan, spirv, device).map_err(|e| Failure::Render(e.into()))?;
    let count = |kernel: &'static str, s: Statistic| Count {
        kernel,
        executable: s.executable,
        name: s.name,
        value: s.value.to_string(),
    };
    let counts = names.iter().zip(of_kernels).flat_map(|(kernel, all)| {
        // A hash only identifies a kernel.
        let all = all
            .into_iter()
            .filter(|s| !s.name.to_lowercase().contains("hash"));
        all.map(move |s| count(kernel, s))
    });
    Ok(counts.collect())
}

fn preset(arguments: &ExplainArguments) -> Preset {
    let (name, settings) = arguments.settings.preset();
    Preset { name, settings }
}

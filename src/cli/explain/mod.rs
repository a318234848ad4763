//! `vkpt explain SCENE`: what a rendering would bring to a device and why, without rendering.

mod arguments;

use super::console::Console;
use super::destination::{self, Destination, all_written};
use super::exit::{Ending, Failure};
use super::job::Loaded;
use crate::explain::{Preset, Subject, explain as explanation};
use crate::gpu::{Device, Selector};
use crate::kernel::Composed;
use crate::render::{Job, KernelChoice, Plan, PlanLimits};
use crate::report::explanation::page;
pub use arguments::ExplainArguments;

/// Prints the page, or the kernel's GLSL; writes its SPIR-V where it is asked for.
pub fn explain(arguments: &ExplainArguments) -> Result<Ending, Failure> {
    destination::check(&arguments.spirv)?;
    if arguments.glsl && arguments.spirv == Some(Destination::Stdout) {
        return Err(Failure::Usage(
            "--glsl and --spirv - would both be written to stdout".to_owned(),
        ));
    }
    let request = arguments.request();
    let loaded = Loaded::new(&request)?;
    let ready = loaded.prepare(&request)?;
    let job = Job {
        aovs: &arguments.aov,
        kernel: arguments.kernel,
        ..ready.job(&request)?
    };
    let (limits, device) = limits(arguments.device.as_ref())?;
    let plan = Plan::new(&job, limits).map_err(Failure::Render)?;
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
        let subject = Subject {
            job: &job,
            plan: &plan,
            scene: &arguments.scene.name(),
            text: &loaded.text,
            preset: preset(arguments),
            auto: ready.why,
            device: &device,
        };
        page(&explanation(&subject, &spirv, (&full, &full_spirv)))
    };
    let to = arguments.spirv.iter().cycle();
    let written = to
        .zip(&spirv)
        .enumerate()
        .map(|(i, (to, spirv))| numbered(to, i).write(|out| out.write_all(spirv.bytes())));
    let written: Vec<_> = written.collect();
    let told = Console::beside(&arguments.spirv).print(&text);
    all_written(written.into_iter().chain([told]))?;
    Ok(Ending::Complete)
}

/// Where kernel `i` goes: the first to FILE itself, the next to FILE-2.
fn numbered(to: &Destination, i: usize) -> Destination {
    match (to.path(), i) {
        (None, _) | (_, 0) => to.clone(),
        (Some(path), i) => {
            let mut name = path.file_stem().unwrap_or_default().to_owned();
            name.push(format!("-{}", i + 1));
            let mut numbered = path.with_file_name(name);
            if let Some(suffix) = path.extension() {
                numbered.set_extension(suffix);
            }
            Destination::File(numbered)
        }
    }
}

/// Those of the device that is asked for, else of the best there is, else those of most GPUs; and whose they are.
fn limits(device: Option<&Selector>) -> Result<(PlanLimits, String), Failure> {
    match (Device::open(device.unwrap_or(&Selector::Best)), device) {
        (Ok(opened), _) => Ok((PlanLimits::of(&opened), opened.info().name.clone())),
        (Err(error), Some(_)) => Err(Failure::Render(error.into())),
        (Err(_), None) => {
            let name = "those of most GPUs (there is no Vulkan device here)";
            Ok((PlanLimits::default(), name.to_owned()))
        }
    }
}

fn preset(arguments: &ExplainArguments) -> Preset {
    let (name, settings) = arguments.settings.preset();
    Preset { name, settings }
}

//! `vkpt doctor`: the properties of a device, and whether its pictures can be trusted.

use crate::check::select::SHORT;
use crate::cli::console::Console;
use crate::cli::destination::{Destination, all_written, json, whole};
use crate::cli::exit::{Ending, Failure, warn};
use crate::cli::interrupt::stop_flag;
use crate::cli::progress::Display;
use crate::cli::values;
use crate::cli::writable;
use crate::doctor::Examiner;
use crate::doctor::report::{Examination, Verdict, head, page};
use vkpt::gpu::{Device, Selector};
use vkpt::render::KernelChoice;

const AFTER_HELP: &str = "\
The verdict comes from self-tests, arithmetic, vkpt's own functions and some cases of `vkpt check`.

Exit codes:
    0  healthy; bits may differ from the reference where Vulkan allows it
    1  a test that pictures depend on failed, or the device stopped responding
    2  the command line is wrong
    4  no Vulkan device, or none that matches --device
    5  the report or stdout could not be written
  130  interrupted by ctrl-c; the findings so far are printed
  143  the same by SIGTERM, 129 by SIGHUP

Examples:
  vkpt doctor                                   test the best device
  vkpt doctor --device 0 --json device.json     test another one, and write all findings";

/// The flags of an examination.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct DoctorArguments {
    /// Vulkan device, by index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    device: Option<Selector>,

    /// Compare vkpt's own functions with the reference at every 32-bit float instead of a million;
    /// takes minutes
    #[arg(long)]
    exhaustive: bool,

    /// Also examine how the driver rewrites arithmetic, GLSL's own functions, and the cost of vkpt's;
    /// none of them changes the verdict
    #[arg(long)]
    all: bool,

    /// Write all findings as JSON; - for stdout
    #[arg(long, value_name = "FILE")]
    json: Option<Destination>,

    /// Print no progress and no page, only failures
    #[arg(long)]
    quiet: bool,
}

/// Prints the page, and writes the record if requested.
pub fn doctor(arguments: &DoctorArguments) -> Result<Ending, Failure> {
    let _claims = writable::check(&arguments.json)?;
    let selector = arguments.device.as_ref().unwrap_or(&Selector::Best);
    let stop = stop_flag();
    let examiner = Examiner {
        exhaustive: arguments.exhaustive,
        all: arguments.all,
        cases: &SHORT,
        own: &[],
        kernel: KernelChoice::Composed,
        stop: &stop,
    };
    let mut display = Display::new(arguments.quiet);
    let mut progress = |done: f64, name: &str| display.show(done, || name.to_owned());
    let examined = Device::open(selector).and_then(|d| examiner.examine(&d, &mut progress));
    display.finish();
    let examination = examined.map_err(|error| Failure::Render(error.into()))?;
    let printed = match arguments.quiet {
        true => Ok(()),
        false => Console::beside(&arguments.json).print(&page(&examination)),
    };
    all_written([printed, whole(&arguments.json, || json(&examination))])?;
    ending(&examination, arguments.quiet)
}

fn ending(examination: &Examination, quiet: bool) -> Result<Ending, Failure> {
    let Verdict {
        healthy, failures, ..
    } = &examination.verdict;
    match (healthy, &failures[..]) {
        (true, _) => Ok(Ending::Complete),
        (false, []) => {
            warn("interrupted: not everything was examined");
            Ok(Ending::Interrupted)
        }
        // The page has the reasons.
        _ if !quiet => Err(Failure::Unhealthy(format!(
            "{} is not healthy",
            examination.device.name
        ))),
        _ => Err(Failure::Unhealthy(head(examination).trim_end().to_owned())),
    }
}

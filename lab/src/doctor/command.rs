//! `vkpt doctor`: what a device is like, and whether its pictures can be trusted.

use crate::cli::console::Console;
use crate::cli::destination::{Destination, all_written, json, whole};
use crate::cli::exit::{Ending, Failure};
use crate::cli::values;
use crate::cli::writable;
use crate::doctor::Examiner;
use crate::doctor::report::page;
use vkpt::gpu::{Device, Selector};

const AFTER_HELP: &str = "\
Exit codes:
    0  healthy; bits may differ from the reference's where Vulkan allows it
    1  something failed that pictures depend on, or the device gave up
    2  the command line is wrong
    4  there is no such Vulkan device, or none at all
    5  the report or stdout could not be written

Examples:
  vkpt doctor                                   can the best device's pictures be trusted?
  vkpt doctor --device 0 --json device.json     another one; all findings for scripts";

/// How a device is examined.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct DoctorArguments {
    /// A Vulkan device, by its index or part of its name [default: the best there is]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    device: Option<Selector>,

    /// Hold vkpt's own functions against the reference at every 32-bit float instead of a million:
    /// minutes
    #[arg(long)]
    exhaustive: bool,

    /// Write all findings; - for stdout
    #[arg(long, value_name = "FILE")]
    json: Option<Destination>,
}

/// Prints the page, writes the record where it is asked for.
pub fn doctor(arguments: &DoctorArguments) -> Result<Ending, Failure> {
    let _claims = writable::check(&arguments.json)?;
    let selector = arguments.device.as_ref().unwrap_or(&Selector::Best);
    let examiner = Examiner {
        exhaustive: arguments.exhaustive,
        own: &[],
    };
    let examined = Device::open(selector).and_then(|device| examiner.examine(&device));
    let examination = examined.map_err(|error| Failure::Render(error.into()))?;
    all_written([
        Console::beside(&arguments.json).print(&page(&examination)),
        whole(&arguments.json, || json(&examination)),
    ])?;
    match examination.verdict.healthy {
        true => Ok(Ending::Complete),
        false => Err(Failure::Unhealthy(examination.device.name)),
    }
}

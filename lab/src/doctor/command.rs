//! `vkpt doctor`: the properties of a device, and whether its pictures can be trusted.

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
    0  healthy; bits may differ from the reference where Vulkan allows it
    1  a test that pictures depend on failed, or the device stopped responding
    2  the command line is wrong
    4  no Vulkan device, or none that matches --device
    5  the report or stdout could not be written

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

    /// Write all findings as JSON; - for stdout
    #[arg(long, value_name = "FILE")]
    json: Option<Destination>,
}

/// Prints the page, and writes the record if requested.
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

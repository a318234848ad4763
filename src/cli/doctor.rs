//! `vkpt doctor`: what a device is like, and whether its pictures can be trusted.

use std::io::Write;
use std::path::PathBuf;

use super::exit::{Ending, Failure};
use super::values;
use crate::doctor::Examiner;
use crate::gpu::{Device, Selector};
use crate::image::file::{check_writable, write_whole};
use crate::report::doctor::{Examination, page};

const EXIT_CODES: &str = "\
Exit codes:
    0  healthy; bits may differ from the reference's where Vulkan allows it
    1  something failed that pictures depend on, or the device gave up
    2  the command line is wrong
    4  there is no such Vulkan device, or none at all
    5  the report could not be written";

/// How a device is examined.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES, max_term_width = 100)]
pub struct DoctorArguments {
    /// A Vulkan device, by its index or part of its name [default: the best there is]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    device: Option<Selector>,

    /// Hold vkpt's own functions against the reference at every 32-bit float instead of a million:
    /// minutes
    #[arg(long)]
    exhaustive: bool,

    /// Write all findings
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Prints the page, writes the record where it is asked for.
pub fn doctor(arguments: &DoctorArguments) -> Result<Ending, Failure> {
    let files = |error| Failure::Files(vec![error]);
    if let Some(path) = &arguments.json {
        check_writable(path).map_err(files)?;
    }
    let selector = arguments.device.as_ref().unwrap_or(&Selector::Best);
    let examiner = Examiner {
        exhaustive: arguments.exhaustive,
        own: &[],
    };
    let examined = Device::open(selector).and_then(|device| examiner.examine(&device));
    let examination = examined.map_err(|error| Failure::Render(error.into()))?;
    // A reader that has gone away is no reason to fail.
    let _ = write!(std::io::stdout(), "{}", page(&examination));
    if let Some(path) = &arguments.json {
        write_whole(path, |out| json(&examination, out)).map_err(files)?;
    }
    match examination.verdict.healthy {
        true => Ok(Ending::Complete),
        false => Err(Failure::Unhealthy(examination.device.name)),
    }
}

fn json(examination: &Examination, out: &mut dyn Write) -> std::io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, examination)?;
    writeln!(out)
}

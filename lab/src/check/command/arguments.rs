//! Every flag of `vkpt check`, with its help.

use crate::cli::destination::Destination;
use crate::cli::values;
use vkpt::gpu::Selector;
use vkpt::settings::Integrator;

const AFTER_HELP: &str = "\
This is the whole battery. `vkpt doctor` runs some of its cases, and says whether to trust a device.

Exit codes:
    0  every case is within its bounds
    1  a case fails or could not run
    2  the command line is wrong
    4  no Vulkan device, or none that matches --device
    5  a report or stdout could not be written
    6  not enough memory
  130  interrupted by ctrl-c; the cases done by then are reported
  143  interrupted by SIGTERM; 129 by SIGHUP

Examples:
  vkpt check --quick                     a minute, on any Vulkan device
  vkpt check --case alpha/ggx            one case, or all below a name
  vkpt check --quick --html check.html   a page with the table and the pictures";

/// The cases to run, and the device.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct CheckArguments {
    /// Skip the cases that take seconds; the rest take a minute in all on two cores
    #[arg(long)]
    pub quick: bool,

    /// Run only this case, group of cases, or pattern with *: alpha, alpha/ggx, 'furnace/*/1e5'
    #[arg(long = "case", value_name = "NAME")]
    pub case: Option<String>,

    /// Integrator that renders the cases: path or bidirectional
    #[arg(long, value_name = "NAME", default_value = "path", value_parser = values::choice::<Integrator>(),
          hide_possible_values = true)]
    pub integrator: Integrator,

    /// Vulkan device, by index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// Write every figure and bound of each case as JSON; - for stdout
    #[arg(long, value_name = "FILE")]
    pub json: Option<Destination>,

    /// Write a self-contained HTML page with the table, coloured by margin, and the pictures of each
    /// case; - for stdout
    #[arg(long, value_name = "FILE")]
    pub html: Option<Destination>,

    /// Print only failures: no progress, no table
    #[arg(long)]
    pub quiet: bool,
}

//! Every flag of `vkpt check`, with its help.

use crate::cli::destination::Destination;
use crate::cli::values;
use vkpt::gpu::Selector;
use vkpt::settings::Integrator;

const AFTER_HELP: &str = "\
Exit codes:
    0  every case is within its bounds
    1  a case fails, or could not be run
    2  the command line is wrong
    4  there is no such Vulkan device, or none at all
    5  a report or stdout could not be written
    6  there is not enough memory
  130  interrupted by ctrl-c; the cases done by then are told
  143  the same by SIGTERM, 129 by SIGHUP

Examples:
  vkpt check --quick                     a minute, on any Vulkan device
  vkpt check --case alpha/ggx            one case, or all below a name
  vkpt check --quick --html check.html   a page with the table and the pictures";

/// Which cases run where.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct CheckArguments {
    /// Leave out the cases that take seconds: a minute in all on two cores
    #[arg(long)]
    pub quick: bool,

    /// Only this case, group of cases, or what a pattern with * means: alpha, alpha/ggx, 'furnace/*/1e5'
    #[arg(long = "case", value_name = "NAME")]
    pub case: Option<String>,

    /// The integrator that renders the cases, path or bidirectional
    #[arg(long, value_name = "NAME", default_value = "path", value_parser = values::choice::<Integrator>(),
          hide_possible_values = true)]
    pub integrator: Integrator,

    /// The Vulkan device, by its index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// Write every figure and bound of each case; - for stdout
    #[arg(long, value_name = "FILE")]
    pub json: Option<Destination>,

    /// Write a page with the table, coloured by margin, and the pictures of each case: one file that
    /// needs no network; - for stdout
    #[arg(long, value_name = "FILE")]
    pub html: Option<Destination>,

    /// No progress and no table, only what fails
    #[arg(long)]
    pub quiet: bool,
}

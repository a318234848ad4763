//! Every flag of `vkpt merge`, with its help.

use std::path::PathBuf;

use crate::outputs::OutputArguments;
use vkpt_lab::cli::numbers;

const AFTER_HELP: &str = "\
Exit codes:
    0  everything is written
    2  the command line is wrong
    3  a part cannot be read or belongs to another picture, or samples are missing or duplicated;
       nothing was written
    5  a file or stdout could not be written
    6  not enough memory

Examples:
  vkpt scene.txt --samples 0..512 -o a.vkpt
  vkpt scene.txt --samples 512..1024 -o b.vkpt
  vkpt merge a.vkpt b.vkpt -o scene.exr     the picture of --spp 1024, to the bit";

/// The parts to merge, and the outputs.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct MergeArguments {
    /// Parts, in any order: .vkpt files of one scene, with equal settings, seed and size
    #[arg(value_name = "PART", required = true)]
    pub parts: Vec<PathBuf>,

    /// Require this many samples per pixel: if the parts have fewer, write nothing
    #[arg(long, value_name = "N", value_parser = numbers::whole(1))]
    pub spp: Option<u32>,

    #[command(flatten)]
    pub outputs: OutputArguments,
}

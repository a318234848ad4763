//! Every flag of `vkpt explain`, with its help.

use crate::cli::beside::{Beside, BesideParser};
use crate::cli::destination::Destination;
use crate::cli::job::Request;
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values::{self, choice};
use crate::cli::view::ViewArguments;
use vkpt::gpu::Selector;
use vkpt::render::KernelChoice;

const AFTER_HELP: &str = "\
Exit codes:
    0  explained
    1  the kernel does not compile, which is a mistake of vkpt's
    2  the command line is wrong
    3  the scene or one of its meshes is wrong; nothing was written
    4  there is no such Vulkan device as --device asks for, or none for --statistics
    5  a file or stdout could not be written
    6  there is not enough memory

Examples:
  vkpt explain scene.txt                          what the kernel holds and why
  vkpt explain scene.txt --glsl > scene.glsl      its source
  vkpt explain scene.txt --spirv scene.spv        the module that a device gets";

/// What is to be explained.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct ExplainArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    #[command(flatten)]
    pub view: ViewArguments,

    /// What else is to be written of the pixels: stderr, or layers of the picture's EXR, light:PATTERN
    /// among them
    #[arg(long, value_name = "WHAT", value_delimiter = ',')]
    #[arg(value_parser = BesideParser)]
    pub aov: Vec<Beside>,

    /// Keep the limits of this Vulkan device, by its index or part of its name [default: the best
    /// there is; where there is none, limits that most GPUs have]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// What the kernel is to hold: composed, what scene and settings need, or full, what any scene
    /// could need
    #[arg(long, value_name = "KERNEL", default_value = "composed")]
    #[arg(value_parser = choice::<KernelChoice>(), hide_possible_values = true)]
    pub kernel: KernelChoice<'static>,

    /// Print the kernel's GLSL, file by file, and nothing else
    #[arg(long)]
    pub glsl: bool,

    /// Write the kernel's SPIR-V; - for stdout
    #[arg(long, value_name = "FILE")]
    pub spirv: Option<Destination>,

    /// Compile the kernel for the device and print the driver's counts for its code: registers,
    /// spills, instructions (VK_KHR_pipeline_executable_properties)
    #[arg(long, conflicts_with = "glsl")]
    pub statistics: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

impl ExplainArguments {
    /// The scene and what would be rendered of it.
    pub fn request(&self) -> Request<'_> {
        // No kernel and no buffer depends on samples and seed.
        self.view.request(&self.scene, &self.settings, 1, 0)
    }
}

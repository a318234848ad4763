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
    1  the kernel does not compile, which is a bug in vkpt
    2  the command line is wrong
    3  the scene or one of its meshes is wrong; nothing was written
    4  no Vulkan device matches --device, or none is available for --statistics
    5  a file or stdout could not be written
    6  not enough memory

Examples:
  vkpt explain scene.txt                          the parts of the kernel, and why
  vkpt explain scene.txt --glsl > scene.glsl      its source
  vkpt explain scene.txt --spirv scene.spv        the module for the device";

/// The flags of an explanation.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct ExplainArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    #[command(flatten)]
    pub view: ViewArguments,

    /// Explain a rendering that also writes these: stderr, or layers of the picture's EXR, including
    /// light:PATTERN
    #[arg(long, value_name = "LAYERS", value_delimiter = ',')]
    #[arg(value_parser = BesideParser)]
    pub aov: Vec<Beside>,

    /// Use the limits of this Vulkan device, by index or part of its name [default: the best device;
    /// if none is available, limits common to most GPUs]
    #[arg(long, value_name = "DEVICE", value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// Kernel to explain: composed, with only the parts that scene and settings need, or full, with
    /// all parts
    #[arg(long, value_name = "KERNEL", default_value = "composed")]
    #[arg(value_parser = choice::<KernelChoice>(), hide_possible_values = true)]
    pub kernel: KernelChoice<'static>,

    /// Print only the kernel's GLSL, file by file
    #[arg(long)]
    pub glsl: bool,

    /// Write the kernel's SPIR-V; - for stdout
    #[arg(long, value_name = "FILE")]
    pub spirv: Option<Destination>,

    /// Compile the kernel for the device and print the driver's statistics: registers, spills,
    /// instructions (VK_KHR_pipeline_executable_properties)
    #[arg(long, conflicts_with = "glsl")]
    pub statistics: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

impl ExplainArguments {
    /// The scene and the rendering to explain.
    pub fn request(&self) -> Request<'_> {
        // Kernels and buffers depend on neither samples nor seed.
        self.view.request(&self.scene, &self.settings, 1, 0)
    }
}

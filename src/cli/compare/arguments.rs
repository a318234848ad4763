//! Every flag of `vkpt compare`, with its help.

use std::path::PathBuf;

use crate::cli::arguments::SettingArguments;
use crate::cli::job::Request;
use crate::cli::values;
use crate::gpu::Selector;

const EXIT_CODES: &str = "\
Exit codes:
    0  compared
    1  a Vulkan device of the CPU differs from cpu-f32 in a bit, the paths that parted are biased, or
       rendering failed
    2  the command line is wrong
    3  the scene or one of its meshes is wrong
    4  there is no such Vulkan device, or none at all
  130  interrupted by ctrl-c";

/// What is to be compared.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES, max_term_width = 100)]
pub struct CompareArguments {
    #[command(flatten)]
    pub paired: PairedArguments,
}

/// A comparison of renderers, path by path.
#[derive(clap::Args, Debug)]
pub struct PairedArguments {
    /// Render this scene on the Vulkan device, by cpu-f32 and by cpu-f64, with the same random
    /// numbers, and tell which paths stay together, how close they are, and which part
    #[arg(long = "paired", value_name = "SCENE", help_heading = PAIRED, required = true)]
    scene: Option<PathBuf>,

    /// Samples per pixel
    #[arg(long, value_name = "N", help_heading = PAIRED, default_value = "16")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..))]
    pub spp: u32,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", help_heading = PAIRED, default_value = "0")]
    pub seed: u32,

    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", help_heading = PAIRED, value_parser = values::size)]
    pub size: Option<[u32; 2]>,

    /// Only these pixels, counted from the top left; X1 and Y1 are excluded
    #[arg(long, value_name = "X0,Y0,X1,Y1", help_heading = PAIRED, value_parser = values::crop)]
    pub crop: Option<[u32; 4]>,

    /// The Vulkan device, by its index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", help_heading = PAIRED, value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// No progress and no table, only warnings and errors
    #[arg(long, help_heading = PAIRED)]
    pub quiet: bool,

    /// Take every warning about the scene as an error
    #[arg(long, help_heading = PAIRED)]
    pub strict: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

const PAIRED: &str = "Same paths";

impl PairedArguments {
    /// The scene and what is to be rendered of it; `None` where no scene is to be rendered.
    pub fn request(&self) -> Option<Request<'_>> {
        Some(Request {
            scene: self.scene.as_deref()?,
            settings: self.settings.settings(),
            size: self.size,
            crop: self.crop,
            spp: self.spp,
            seed: self.seed,
            strict: self.strict,
        })
    }

    /// The Vulkan device.
    pub fn device(&self) -> Selector {
        self.device.clone().unwrap_or(Selector::Best)
    }
}

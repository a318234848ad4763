//! Every flag of `vkpt compare`, with its help.

use std::path::PathBuf;

use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Id};

use crate::cli::destination::Destination;
use crate::cli::job::Request;
use crate::cli::numbers;
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values;
use crate::cli::view::ViewArguments;
use vkpt::gpu::Selector;

const AFTER_HELP: &str = "\
Exit codes:
    0  compared, and as close as the flags demand
    1  --max-relmse or --z-test failed; a Vulkan device of the CPU differs from cpu-f32 in a bit, or
       the paths that parted are biased; rendering failed
    2  the command line is wrong
    3  a picture can't be read or compared, or its standard errors are of another; the scene or one
       of its meshes is wrong
    4  there is no such Vulkan device, or none at all
    5  the heat map or stdout could not be written
    6  there is not enough memory
  130  interrupted by ctrl-c
  143  the same by SIGTERM, 129 by SIGHUP

Examples:
  vkpt compare a.exr b.exr                          how far is a from b?
  vkpt compare a.exr b.exr --heatmap map.png        where?
  vkpt compare a.exr b.exr --z-test                 is the difference chance?
  vkpt compare --paired scene.txt                   the device and the reference, path by path";

/// What is to be compared.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
#[command(
    override_usage = "vkpt compare [OPTIONS] <A> <B>\n       vkpt compare [OPTIONS] --paired <SCENE>"
)]
pub struct CompareArguments {
    #[command(flatten)]
    pub pictures: PictureArguments,

    #[command(flatten)]
    pub paired: PairedArguments,
}

impl CompareArguments {
    /// What is wrong where a flag of one comparison is given with the other, which would not look at it.
    ///
    /// clap's `requires` does not tell: it is content where what is required conflicts with what is there.
    pub fn misplaced(matches: &ArgMatches) -> Option<String> {
        let given = |id: &Id| matches.value_source(id.as_str()) == Some(ValueSource::CommandLine);
        let none = clap::Command::default();
        let (others, needed) = match given(&Id::from("scene")) {
            true => (PictureArguments::augment_args(none), "two pictures"),
            false => (PairedArguments::augment_args(none), "--paired <SCENE>"),
        };
        let flags: Vec<String> = others
            .get_arguments()
            .filter(|flag| given(flag.get_id()))
            .filter_map(|flag| Some(format!("--{}", flag.get_long()?)))
            .collect();
        (!flags.is_empty()).then(|| format!("{} can be used with {needed} only", flags.join(", ")))
    }
}

/// A comparison of pictures.
#[derive(clap::Args, Debug)]
pub struct PictureArguments {
    /// The picture to judge: EXR, HDR or PNG, of any renderer
    #[arg(
        value_name = "A",
        required_unless_present = "scene",
        requires = "b",
        conflicts_with = "scene"
    )]
    pub a: Option<PathBuf>,

    /// The picture to judge it by; with --reference a second one to judge
    #[arg(value_name = "B", required_unless_present = "scene")]
    pub b: Option<PathBuf>,

    /// Judge both pictures by this one
    #[arg(long, value_name = "FILE", help_heading = PICTURES)]
    pub reference: Option<PathBuf>,

    /// Standard errors of the pictures' values: once for each picture, in order [default:
    /// NAME-stderr.exr beside each, as `vkpt SCENE --aov stderr` writes it]
    #[arg(long, value_name = "FILE", help_heading = PICTURES)]
    pub stderr: Vec<PathBuf>,

    /// Compare this layer of EXR files in place of the pictures: Albedo, N, Ns, P, Z, or any other's
    /// NAME of channels NAME.R, NAME.X or NAME alone; light:PATTERN as --aov has it
    #[arg(long, value_name = "NAME", help_heading = PICTURES)]
    pub layer: Option<String>,

    /// Stops by which FLIP brightens the pictures before it looks at them as PNGs
    #[arg(long, value_name = "EV", help_heading = PICTURES, default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Write the relative squared error of each pixel as a colour; with --reference both maps, side
    /// by side; - for stdout
    #[arg(long, value_name = "FILE.png", help_heading = PICTURES)]
    #[arg(value_parser = values::png())]
    pub heatmap: Option<Destination>,

    /// Fail (exit code 1) if a relMSE is above X
    #[arg(long, value_name = "X", help_heading = PICTURES)]
    #[arg(value_parser = numbers::bound)]
    pub max_relmse: Option<f64>,

    /// Fail (exit code 1) if the means of blocks of 25x25 pixels differ by more than the standard
    /// errors explain
    #[arg(long, help_heading = PICTURES)]
    pub z_test: bool,
}

/// A comparison of renderers, path by path.
#[derive(clap::Args, Debug)]
pub struct PairedArguments {
    /// Render this scene (- for stdin) on the Vulkan device, by cpu-f32 and by cpu-f64, with the same random
    /// numbers, and tell which paths stay together, how close they are, and which part
    #[arg(long = "paired", value_name = "SCENE", help_heading = PAIRED)]
    scene: Option<Source>,

    /// Samples per pixel
    #[arg(long, value_name = "N", help_heading = PAIRED, default_value = "16")]
    #[arg(value_parser = numbers::whole(1))]
    pub spp: u32,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", help_heading = PAIRED, default_value = "0")]
    #[arg(value_parser = numbers::whole(0))]
    pub seed: u32,

    #[command(flatten, next_help_heading = PAIRED)]
    view: ViewArguments,

    /// The Vulkan device, by its index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", help_heading = PAIRED, value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// No progress and no table, only warnings and errors
    #[arg(long, help_heading = PAIRED)]
    pub quiet: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

const PICTURES: &str = "Pictures";
const PAIRED: &str = "Same paths";

impl PairedArguments {
    /// The scene and what is to be rendered of it; `None` where no scene is to be rendered.
    pub fn request(&self) -> Option<Request<'_>> {
        let (scene, settings) = (self.scene.as_ref()?, &self.settings);
        Some(self.view.request(scene, settings, self.spp, self.seed))
    }

    /// The Vulkan device.
    pub fn device(&self) -> Selector {
        self.device.clone().unwrap_or(Selector::Best)
    }
}

impl PictureArguments {
    /// A, B and the reference, as far as they are given.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        self.a.iter().chain(&self.b).chain(&self.reference)
    }
}

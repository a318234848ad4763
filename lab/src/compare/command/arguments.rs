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
    1  --max-relmse or --z-test failed; a CPU's Vulkan device differs from cpu-f32 in a bit, or the
       diverged paths are biased; rendering failed
    2  the command line is wrong
    3  a picture cannot be read or compared, or its standard errors belong to another picture; the
       scene or one of its meshes is wrong
    4  no Vulkan device, or none that matches --device
    5  the heat map or stdout could not be written
    6  not enough memory
  130  interrupted by ctrl-c
  143  interrupted by SIGTERM; 129 by SIGHUP

Examples:
  vkpt compare a.exr b.exr                          how far is a from b?
  vkpt compare a.exr b.exr --heatmap map.png        where?
  vkpt compare a.exr b.exr --z-test                 is the difference chance?
  vkpt compare --paired scene.txt                   the device and the reference, path by path";

/// The pictures or renderers to compare.
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
    /// The error if a flag of one comparison is given with the other, which would ignore it.
    ///
    /// clap's `requires` does not detect this: it accepts a missing argument that conflicts with one given.
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
    /// Picture to judge: EXR, HDR or PNG, from any renderer
    #[arg(
        value_name = "A",
        required_unless_present = "scene",
        requires = "b",
        conflicts_with = "scene"
    )]
    pub a: Option<PathBuf>,

    /// Picture to compare A with; with --reference, a second picture to judge
    #[arg(value_name = "B", required_unless_present = "scene")]
    pub b: Option<PathBuf>,

    /// Compare both pictures with this one
    #[arg(long, value_name = "FILE", help_heading = PICTURES)]
    pub reference: Option<PathBuf>,

    /// Standard errors of a picture; give the flag once for each picture, in order [default:
    /// NAME-stderr.exr next to each, as `vkpt SCENE --aov stderr` writes it]
    #[arg(long, value_name = "FILE", help_heading = PICTURES)]
    pub stderr: Vec<PathBuf>,

    /// Compare this layer of EXR files instead of the pictures: Albedo, N, Ns, P, Z, or the NAME of
    /// channels NAME.R, NAME.X or NAME; light:PATTERN as for --aov
    #[arg(long, value_name = "NAME", help_heading = PICTURES)]
    pub layer: Option<String>,

    /// Brighten the pictures by this many stops before FLIP compares them as PNGs
    #[arg(long, value_name = "EV", help_heading = PICTURES, default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Write a heat map of each pixel's relative squared error; with --reference both maps, side by
    /// side; - for stdout
    #[arg(long, value_name = "FILE.png", help_heading = PICTURES)]
    #[arg(value_parser = values::png())]
    pub heatmap: Option<Destination>,

    /// Exit with code 1 if a relMSE is above X
    #[arg(long, value_name = "X", help_heading = PICTURES)]
    #[arg(value_parser = numbers::bound)]
    pub max_relmse: Option<f64>,

    /// Exit with code 1 if the means of 25x25 pixel blocks differ by more than the standard errors
    /// explain
    #[arg(long, help_heading = PICTURES)]
    pub z_test: bool,
}

/// A comparison of renderers, path by path.
#[derive(clap::Args, Debug)]
pub struct PairedArguments {
    /// Render this scene (- for stdin) on the Vulkan device, by cpu-f32 and by cpu-f64, with the same
    /// random numbers, and report how many paths diverge and how close the others are
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

    /// Vulkan device, by index or part of its name [default: the best]
    #[arg(long, value_name = "DEVICE", help_heading = PAIRED, value_parser = values::vulkan_device)]
    pub device: Option<Selector>,

    /// Print only warnings and errors: no progress, no table
    #[arg(long, help_heading = PAIRED)]
    pub quiet: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

const PICTURES: &str = "Pictures";
const PAIRED: &str = "Same paths";

impl PairedArguments {
    /// The scene and the rendering requested; `None` if no scene is to be rendered.
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
    /// A, B and the reference, those that are given.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        self.a.iter().chain(&self.b).chain(&self.reference)
    }
}

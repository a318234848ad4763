//! Every flag of `vkpt test`, with its help.

use std::path::PathBuf;

use crate::cli::destination::Destination;
use crate::cli::job::Request;
use crate::cli::numbers;
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values;
use crate::cli::view::ViewArguments;
use vkpt::render::Target;

const AFTER_HELP: &str = "\
Exit codes:
    0  every scene makes its kept picture, or with --bless one that is kept now
    1  a picture differs, is missing or could not be made
    2  the command line is wrong, or there are no scenes
    4  there is no such Vulkan device, or none at all
    5  a file or stdout could not be written
    6  there is not enough memory
  130  interrupted by ctrl-c; the scenes done by then are told
  143  the same by SIGTERM, 129 by SIGHUP

Examples:
  vkpt test pictures --bless               keep the pictures of all scenes in pictures/
  vkpt test pictures                       render them again: the same to the bit?
  vkpt test pictures --junit results.xml   the same for a CI service
  vkpt test pictures --html test.html      a page with the pictures of what differs
  vkpt test pictures --device 0 --max-relmse 1e-3";

/// Which scenes are rendered, and what is expected of them.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct TestArguments {
    /// The folder of the scenes, in it or below: NAME.txt, .scn, .gltf or .glb, each beside the picture
    /// that it is to make, NAME.expected.exr
    pub folder: PathBuf,

    /// Keep the pictures that the scenes make now, where they differ from those kept before
    #[arg(long)]
    pub bless: bool,

    /// Allow pictures a relMSE of so much, in place of equal bits
    #[arg(long, value_name = "X", value_parser = numbers::target_error, conflicts_with = "bless")]
    pub max_relmse: Option<f64>,

    /// Folder for what differs, made where it is needed: NAME.actual.exr, NAME.difference.png,
    /// and reports that go there
    #[arg(long, value_name = "FOLDER", default_value = "test-results")]
    pub out: PathBuf,

    /// Write the results as JUnit's XML, which CI services show; - for stdout
    #[arg(long, value_name = "FILE.xml")]
    pub junit: Option<Destination>,

    /// Write a page with all scenes, and the pictures of what differs beside the kept ones: one file that
    /// needs no network; - for stdout
    #[arg(long, value_name = "FILE.html")]
    pub html: Option<Destination>,

    /// Samples per pixel
    #[arg(long, value_name = "N", default_value = "64", value_parser = numbers::whole(1))]
    pub spp: u32,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "0", value_parser = numbers::whole(0))]
    pub seed: u32,

    /// What renders: cpu-f32, whose bits are the same on every machine, cpu-f64, or a Vulkan device by its
    /// index or part of its name
    #[arg(long, value_name = "DEVICE", default_value = "cpu-f32", value_parser = values::device)]
    pub device: Target,

    #[command(flatten)]
    pub view: ViewArguments,

    /// No progress and no lines, only what is wrong
    #[arg(long)]
    pub quiet: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

impl TestArguments {
    /// The reports.
    pub fn reports(&self) -> impl Iterator<Item = &Destination> {
        self.junit.iter().chain(&self.html)
    }

    /// What is to be rendered of a scene.
    pub fn request<'a>(&'a self, scene: &'a Source) -> Request<'a> {
        Request {
            quiet: true,
            ..self
                .view
                .request(scene, &self.settings, self.spp, self.seed)
        }
    }
}

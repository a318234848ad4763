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
    0  every scene matches its expected picture, or with --bless its picture is now kept
    1  a picture differs, is missing or could not be rendered
    2  the command line is wrong, or the folder contains no scenes
    4  no Vulkan device, or none that matches --device
    5  a file or stdout could not be written
    6  not enough memory
  130  interrupted by ctrl-c; the scenes done by then are reported
  143  interrupted by SIGTERM; 129 by SIGHUP

Examples:
  vkpt test pictures --bless               keep the pictures of all scenes in pictures/ as expected
  vkpt test pictures                       render them again, and compare every bit
  vkpt test pictures --junit results.xml   also write a report for a CI service
  vkpt test pictures --html test.html      also write a page with the pictures that differ
  vkpt test pictures --device 0 --max-relmse 1e-3";

/// The scenes to render, and the expected pictures.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct TestArguments {
    /// Folder of the scenes, searched recursively: NAME.txt, .scn, .gltf or .glb, each next to its
    /// expected picture, NAME.expected.exr
    pub folder: PathBuf,

    /// Keep the new pictures as the expected ones where they differ
    #[arg(long)]
    pub bless: bool,

    /// Accept pictures with a relMSE up to this, instead of requiring equal bits
    #[arg(long, value_name = "X", value_parser = numbers::target_error, conflicts_with = "bless")]
    pub max_relmse: Option<f64>,

    /// Folder for pictures that differ, NAME.actual.exr and NAME.difference.png, and for reports that
    /// are written there; created if needed
    #[arg(long, value_name = "FOLDER", default_value = "test-results")]
    pub out: PathBuf,

    /// Write the results as JUnit XML, which CI services show; - for stdout
    #[arg(long, value_name = "FILE.xml")]
    pub junit: Option<Destination>,

    /// Write a self-contained HTML page with all scenes, and the pictures that differ next to the
    /// expected ones; - for stdout
    #[arg(long, value_name = "FILE.html")]
    pub html: Option<Destination>,

    /// Samples per pixel
    #[arg(long, value_name = "N", default_value = "64", value_parser = numbers::whole(1))]
    pub spp: u32,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "0", value_parser = numbers::whole(0))]
    pub seed: u32,

    /// Device: cpu-f32, whose bits are the same on every machine, cpu-f64, or a Vulkan device by index
    /// or part of its name
    #[arg(long, value_name = "DEVICE", default_value = "cpu-f32", value_parser = values::device)]
    pub device: Target,

    #[command(flatten)]
    pub view: ViewArguments,

    /// Print only failures: no progress, no other lines
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

    /// The rendering of a scene.
    pub fn request<'a>(&'a self, scene: &'a Source) -> Request<'a> {
        Request {
            quiet: true,
            ..self
                .view
                .request(scene, &self.settings, self.spp, self.seed)
        }
    }
}

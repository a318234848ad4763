//! Every flag of `vkpt farm`, with its help.

use super::typed::Typed;
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::job::Request;
use vkpt_lab::cli::numbers;
use vkpt_lab::cli::settings::SettingArguments;
use vkpt_lab::cli::source::Source;
use vkpt_lab::cli::view::ViewArguments;

const AFTER_HELP: &str = "\
Exit codes:
    0  the scripts are written, and submitted if requested
    1  the scripts are written, but could not be submitted
    2  the command line is wrong, or a folder already contains parts of a rendering
    3  a scene or one of its meshes is wrong; nothing was written
    5  a file or stdout could not be written
    6  not enough memory

Examples:
  vkpt farm slurm scene.txt --spp 65536 --tasks 64     write scripts to scene.farm/
  vkpt farm slurm scene.txt --tasks 64 --submit        submit them, too
  vkpt farm slurm shots/*.txt --spp 1024               a folder and a task for each scene";

const EXAMPLES: &str = "\
Examples:
  vkpt farm slurm scene.txt --spp 65536 --tasks 64     write scripts to scene.farm/

See `vkpt farm slurm --help` for all options and exit codes.";

/// The batch system that renders.
#[derive(clap::Args, Debug)]
#[command(subcommand_value_name = "SYSTEM", after_help = EXAMPLES)]
pub struct FarmArguments {
    #[command(subcommand)]
    pub system: System,
}

#[derive(clap::Subcommand, Debug)]
pub enum System {
    /// Write Slurm scripts: an array job that renders parts, and a job that merges them
    Slurm(Box<SlurmArguments>),
}

/// The flags of a Slurm farm.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct SlurmArguments {
    /// Scene files; each gets a folder of scripts
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<Source>,

    /// Picture to write at the end: .png, .hdr or .exr, or .vkpt for a part with all samples; may be
    /// repeated. The scripts go to the folder NAME.farm next to the first [default: the scene's name
    /// with .png and .exr, in the working directory]
    #[arg(short, long = "output", value_name = "FILE")]
    pub output: Vec<Destination>,

    /// Parts to render in parallel, each a task of an array job
    #[arg(long, value_name = "N", default_value = "1", value_parser = numbers::whole(1))]
    pub tasks: u32,

    /// Samples per pixel of all parts together; with --time or --target-error, the maximum [default:
    /// 64; with one of those, unlimited]
    #[arg(long, value_name = "N", value_parser = numbers::whole(1))]
    spp: Option<u32>,

    /// Render in rounds, each with as many samples as all before it; start none that would end more
    /// than this many seconds after the first part started
    #[arg(long, value_name = "S", value_parser = numbers::seconds)]
    pub time: Option<f64>,

    /// Render in rounds, as with --time, until the relMSE is below this with 95 % confidence
    #[arg(long, value_name = "E", value_parser = numbers::target_error)]
    pub target_error: Option<f64>,

    /// Slurm partition [default: the site's]
    #[arg(long, value_name = "NAME")]
    pub partition: Option<String>,

    /// Also submit the jobs with sbatch
    #[arg(long)]
    pub submit: bool,

    /// Device that renders the parts, as named on the machines that render: a Vulkan device, cpu-f32
    /// or cpu-f64 [default: the best of each machine]
    #[arg(long, value_name = "DEVICE")]
    device: Option<String>,

    #[command(flatten)]
    part: Typed<PartArguments>,
}

/// The flags passed to each part.
#[derive(clap::Args, Debug)]
pub struct PartArguments {
    #[command(flatten)]
    view: ViewArguments,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "0", value_parser = numbers::whole(0))]
    seed: u32,

    #[command(flatten)]
    settings: SettingArguments,
}

impl SlurmArguments {
    /// Whether the number of samples is decided while rendering.
    pub fn in_rounds(&self) -> bool {
        self.time.is_some() || self.target_error.is_some()
    }

    /// The maximum number of samples per pixel.
    pub fn spp(&self) -> u32 {
        let unasked = if self.in_rounds() { u32::MAX } else { 64 };
        self.spp.unwrap_or(unasked)
    }

    /// The flags of each part, as they were typed.
    pub fn flags(&self) -> Vec<String> {
        let device = self.device.iter().map(|name| ["--device", name]);
        let device = device.flatten().map(str::to_owned);
        device.chain(self.part.words.iter().cloned()).collect()
    }

    /// A scene and the rendering requested.
    pub fn request<'a>(&'a self, scene: &'a Source) -> Request<'a> {
        let PartArguments {
            view,
            seed,
            settings,
        } = &self.part.read;
        view.request(scene, settings, self.spp(), *seed)
    }
}

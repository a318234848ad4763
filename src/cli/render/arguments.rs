//! Every flag of a rendering, with its help.

use crate::cli::destination::Destination;
use crate::cli::exit::Failure;
use crate::cli::job::Request;
use crate::cli::numbers::{self, SamplePath};
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values::{self, choice};
use crate::cli::view::ViewArguments;
use crate::film::Aov;
use crate::gpu::Selector;
use crate::image::Format;
use crate::render::{self, Best, Job, KernelChoice, Target, Until};

/// What one rendering needs to know.
#[derive(clap::Args, Debug)]
pub struct RenderArguments {
    /// The scene file, or - for stdin
    #[arg(required = true)]
    scene: Option<Source>,

    /// Picture to write: .png (sRGB), .hdr (linear, RGBE) or .exr (linear, f32), or - for stdout; may
    /// be repeated [default: the scene's name with .png and .exr, in the working directory]
    #[arg(short, long = "output", value_name = "FILE", help_heading = "Picture")]
    pub output: Vec<Destination>,

    /// Format of pictures whose name does not tell it, and of stdout: png, hdr or exr
    #[arg(long, value_name = "FORMAT", help_heading = "Picture")]
    #[arg(value_parser = choice::<Format>(), hide_possible_values = true)]
    pub format: Option<Format>,

    #[command(flatten, next_help_heading = "Picture")]
    pub view: ViewArguments,

    /// Write beside each picture what else is known of its pixels. stderr: standard errors of the
    /// mean, to NAME-stderr.exr
    #[arg(
        long,
        value_name = "WHAT",
        help_heading = "Picture",
        value_delimiter = ','
    )]
    #[arg(value_parser = choice::<Aov>(), hide_possible_values = true)]
    pub aov: Vec<Aov>,

    /// Stops by which .png is brightened; negative: darkened
    #[arg(long, value_name = "EV", help_heading = "Picture", default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Samples per pixel, the most where --time or --target-error are given [default: 64, or with
    /// one of those no end]
    #[arg(long, value_name = "N", help_heading = "Rendering")]
    #[arg(value_parser = numbers::whole(1))]
    spp: Option<u32>,

    /// End after so many seconds of rendering, with whole samples in every pixel
    #[arg(long, value_name = "S", help_heading = "Rendering", value_parser = numbers::seconds)]
    pub time: Option<f64>,

    /// End once the relMSE is below this, with 95 % confidence
    #[arg(long, value_name = "E", help_heading = "Rendering", value_parser = numbers::target_error)]
    pub target_error: Option<f64>,

    /// Seed of the random numbers: the same seed gives the same picture, bit for bit
    #[arg(
        long,
        value_name = "N",
        help_heading = "Rendering",
        default_value = "0"
    )]
    #[arg(value_parser = numbers::whole(0))]
    pub seed: u32,

    /// A Vulkan device by its index or part of its name (`vkpt devices` lists them), or the
    /// reference renderer: cpu-f64, cpu-f32 [default: a GPU; without one, the faster of a CPU's
    /// Vulkan driver and cpu-f32, whose pictures are the same to the bit]
    #[arg(long, value_name = "DEVICE", help_heading = "Rendering", value_parser = values::device)]
    device: Option<Target>,

    /// What the Vulkan kernel holds: composed, what scene and settings need, or full, what any scene
    /// could need. The picture does not depend on it
    #[arg(
        long,
        value_name = "KERNEL",
        help_heading = "Rendering",
        default_value = "composed"
    )]
    #[arg(value_parser = choice::<KernelChoice>(), hide_possible_values = true)]
    pub kernel: KernelChoice<'static>,

    #[command(flatten)]
    pub settings: SettingArguments,

    /// Write what the rendering did and how long it took; - for stdout
    #[arg(long, value_name = "FILE", help_heading = "Reports")]
    pub json: Option<Destination>,

    /// No progress and no summary, only warnings and errors
    #[arg(long, help_heading = "Reports")]
    pub quiet: bool,

    /// Render nothing; print the path of sample I of pixel X,Y (from the top left), vertex by vertex
    #[arg(long, value_name = "X,Y,I", help_heading = "Reports", value_parser = numbers::sample_path)]
    pub trace: Option<SamplePath>,
}

impl RenderArguments {
    /// The scene and what is to be rendered of it.
    pub fn request(&self) -> Result<Request<'_>, Failure> {
        let scene = self.scene()?;
        let request = self
            .view
            .request(scene, &self.settings, self.spp(), self.seed);
        Ok(Request {
            quiet: self.quiet,
            ..request
        })
    }

    /// The most samples that a pixel is to have.
    pub fn spp(&self) -> u32 {
        let endless = self.time.is_some() || self.target_error.is_some();
        self.spp.unwrap_or(if endless { u32::MAX } else { 64 })
    }

    /// What is to end the rendering before that.
    pub fn until(&self) -> Until {
        Until {
            seconds: self.time,
            rel_mse: self.target_error,
        }
    }

    /// Where the scene is.
    pub fn scene(&self) -> Result<&Source, Failure> {
        self.scene
            .as_ref()
            .ok_or_else(|| Failure::Usage("a scene file is missing".to_owned()))
    }

    /// What follows one path: whatever is fast, the device that is asked for or the best Vulkan device.
    pub fn target(&self) -> Target {
        self.device
            .clone()
            .unwrap_or(Target::Vulkan(Selector::Best))
    }

    /// What renders the job, and why where the job decides.
    pub fn best(&self, job: &Job) -> Best {
        match self.device.is_none() && self.kernel == KernelChoice::Composed {
            true => render::best(job),
            false => Best {
                target: self.target(),
                why: None,
            },
        }
    }
}

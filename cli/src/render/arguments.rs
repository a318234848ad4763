//! Every flag of a rendering, with its help.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::live::Onlookers;
use crate::live::command::{Doors, LiveArguments};
use crate::outputs::OutputArguments;
use vkpt::film::Aov;
use vkpt::gpu::Selector;
use vkpt::path_class::PathClass;
use vkpt::render::{
    self, Best, Job, KernelChoice, Outcome, RenderError, Start, Target, Until, Watch,
};
use vkpt::report::names::Named;
use vkpt_lab::cli::beside::parted;
use vkpt_lab::cli::denoise::{self, DenoiseArguments, LEAST};
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::exit::Failure;
use vkpt_lab::cli::job::{Ready, Request};
use vkpt_lab::cli::numbers::Pause;
use vkpt_lab::cli::numbers::{self, SamplePath};
use vkpt_lab::cli::settings::SettingArguments;
use vkpt_lab::cli::source::Source;
use vkpt_lab::cli::values::{self, Devices, choice};
use vkpt_lab::cli::view::ViewArguments;

/// Time between two checkpoints, where nobody says.
const PAUSE: Duration = Duration::from_secs(60);

/// What one rendering needs to know.
#[derive(clap::Args, Debug)]
pub struct RenderArguments {
    /// The scene file, text or glTF, or - for stdin
    #[arg(required = true)]
    pub scene: Option<Source>,

    #[command(flatten)]
    pub outputs: OutputArguments,

    #[command(flatten, next_help_heading = "Picture")]
    pub view: ViewArguments,

    #[command(flatten)]
    pub denoise: DenoiseArguments,

    /// Samples per pixel, the most where --time or --target-error are given [default: 64, or with
    /// one of those no end]
    #[arg(long, value_name = "N", help_heading = "Rendering")]
    #[arg(value_parser = numbers::whole(1))]
    spp: Option<u32>,

    /// Only the samples from index A on, before index B, of every pixel; written to a .vkpt file, which
    /// vkpt merge joins with others
    #[arg(long, value_name = "A..B", help_heading = "Rendering", conflicts_with_all = ["spp", "target_error"])]
    #[arg(value_parser = numbers::sample_range)]
    pub samples: Option<Range<u32>>,

    /// End after so many seconds of rendering, with whole samples in every pixel
    #[arg(long, value_name = "S", help_heading = "Rendering", value_parser = numbers::seconds)]
    pub time: Option<f64>,

    /// End once the relMSE is below this, with 95 % confidence
    #[arg(long, value_name = "E", help_heading = "Rendering", value_parser = numbers::target_error)]
    pub target_error: Option<f64>,

    /// Go on from what an earlier run has left: NAME.vkpt beside the first picture, or the .vkpt file of
    /// -o; begin anew where there is none
    #[arg(long, help_heading = "Rendering")]
    pub resume: bool,

    /// Seconds between two checkpoints: the samples so far, written to that file; or off [default: 60]
    #[arg(long, value_name = "S", help_heading = "Rendering", value_parser = numbers::pause)]
    pub checkpoint: Option<Pause>,

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
    /// reference renderer: cpu-f64, cpu-f32; several, by index, share the samples out, as 0,1 does
    /// [default: a GPU; without one, the faster of a CPU's Vulkan driver and cpu-f32, whose pictures
    /// are the same to the bit]
    #[arg(long, value_name = "DEVICE", help_heading = "Rendering", value_parser = values::devices)]
    device: Option<Devices>,

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
    pub live: LiveArguments,

    #[command(flatten)]
    pub settings: SettingArguments,

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
            .request(scene, &self.settings, self.range().end, self.seed);
        Ok(Request {
            quiet: self.outputs.quiet,
            settings: match self.denoise.denoise {
                Some(_) => denoise::quartered(request.settings),
                None => request.settings,
            },
            ..request
        })
    }

    /// What is made beside the picture: by kinds, and the light of classes of paths.
    pub fn beside(&self) -> (Vec<Aov>, Vec<PathClass>) {
        let (mut aovs, classes) = parted(&self.outputs.aov);
        aovs.extend(self.denoise.denoise.map(|_| Aov::Denoised));
        (aovs, classes)
    }

    /// What is rendered of the scene.
    pub fn job<'a>(
        &self,
        ready: &'a Ready,
        (aovs, classes): &'a (Vec<Aov>, Vec<PathClass>),
    ) -> Result<Job<'a>, Failure> {
        Ok(Job {
            aovs,
            classes,
            kernel: self.kernel,
            until: self.until(),
            ..ready.job(&self.request()?)?
        })
    }

    /// The indices of the samples that a pixel is to have, at most.
    pub fn range(&self) -> Range<u32> {
        let endless = self.time.is_some() || self.target_error.is_some();
        let spp = self.spp.unwrap_or(if endless { u32::MAX } else { 64 });
        self.samples.clone().unwrap_or(0..spp)
    }

    /// Whether there are samples enough to be denoised, where that is asked for.
    pub fn check_denoise(&self) -> Result<(), Failure> {
        let message = match self.denoise.denoise {
            Some(_) if self.samples.is_some() => {
                "--samples makes a part of a picture, and --denoise needs all of it".to_owned()
            }
            Some(_) if (self.range().len() as u32) < LEAST => format!(
                "--denoise needs --spp {LEAST} or more: a quarter of the samples is a picture of its own"
            ),
            _ => return Ok(()),
        };
        Err(Failure::Usage(message))
    }

    /// Renders the job on all devices that are named, else on `target`.
    pub fn develop(
        &self,
        job: &Job,
        target: &Target,
        start: &Start,
        stop: &AtomicBool,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, RenderError> {
        match &self.device {
            Some(Devices::Several(targets)) => {
                render::render_several(job, targets, start, stop, watch)
            }
            _ => render::render_from(job, target, start, stop, watch),
        }
    }

    /// Those who look on, and may set `stop`.
    pub fn onlookers(&self, doors: Doors, stop: &Arc<AtomicBool>) -> Result<Onlookers, Failure> {
        let [left, top, ..] = self.view.crop.unwrap_or_default();
        doors.open(&self.scene()?.name(), [left, top], stop)
    }

    /// What the rendering writes where nobody says.
    pub fn default_outputs(&self) -> Result<Vec<Destination>, Failure> {
        let stem = self.scene()?.stem().ok_or_else(|| {
            Failure::Usage("the scene has no file name to call pictures by: use -o".to_owned())
        })?;
        let named = |ending: &str| {
            let mut name = stem.to_os_string();
            name.push(ending);
            Destination::File(name.into())
        };
        Ok(match (&self.samples, self.outputs.format) {
            (Some(range), _) => vec![named(&format!("-{}-{}.vkpt", range.start, range.end))],
            (None, Some(format)) => vec![named(&format!(".{}", format.name()))],
            (None, None) => vec![named(".png"), named(".exr")],
        })
    }

    /// Time between two checkpoints.
    pub fn pause(&self) -> Option<Duration> {
        self.checkpoint.map_or(Some(PAUSE), |Pause(pause)| pause)
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
        match &self.device {
            None => Target::Vulkan(Selector::Best),
            Some(Devices::One(target)) => target.clone(),
            Some(Devices::Several(targets)) => targets[0].clone(),
        }
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

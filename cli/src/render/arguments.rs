//! Every flag of a rendering, with its help.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::live::Viewers;
use crate::live::command::{Doors, LiveArguments};
use crate::outputs::OutputArguments;
use vkpt::film::Aov;
use vkpt::gpu::Selector;
use vkpt::path_class::PathClass;
use vkpt::render::{
    self, Best, Job, KernelChoice, Outcome, RenderError, Start, Target, Until, Watch,
};
use vkpt::report::names::Named;
use vkpt_lab::cli::beside::split;
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

/// Time between two checkpoints by default.
const PAUSE: Duration = Duration::from_secs(60);

/// The flags of a rendering.
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

    /// Samples per pixel; with --time or --target-error, the maximum [default: 64; with one of those,
    /// unlimited]
    #[arg(long, value_name = "N", help_heading = "Rendering")]
    #[arg(value_parser = numbers::whole(1))]
    spp: Option<u32>,

    /// Render only samples A to B-1 of every pixel, to a .vkpt file for vkpt merge
    #[arg(long, value_name = "A..B", help_heading = "Rendering", conflicts_with_all = ["spp", "target_error"])]
    #[arg(value_parser = numbers::sample_range)]
    pub samples: Option<Range<u32>>,

    /// Stop after this many seconds of rendering, with the same number of samples in every pixel
    #[arg(long, value_name = "S", help_heading = "Rendering", value_parser = numbers::seconds)]
    pub time: Option<f64>,

    /// Stop once the relMSE is below this with 95 % confidence
    #[arg(long, value_name = "E", help_heading = "Rendering", value_parser = numbers::target_error)]
    pub target_error: Option<f64>,

    /// Continue an earlier run from NAME.vkpt next to the first picture, or from the .vkpt file of -o;
    /// if it does not exist, start from the first sample
    #[arg(long, help_heading = "Rendering")]
    pub resume: bool,

    /// Seconds between checkpoints, which write the samples so far to that file; or off [default: 60]
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

    /// Vulkan device, by index or part of its name (see `vkpt devices`), or the reference renderer:
    /// cpu-f64 or cpu-f32; several indices, such as 0,1, share the samples [default: a GPU; without
    /// one, the faster of a CPU's Vulkan driver and cpu-f32, whose pictures are the same to the bit]
    #[arg(long, value_name = "DEVICE", help_heading = "Rendering", value_parser = values::devices)]
    device: Option<Devices>,

    /// Vulkan kernel: composed, with only the parts that scene and settings need, or full, with all
    /// parts. The picture is the same
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

    /// Print the path of sample I of pixel X,Y (from the top left), vertex by vertex, instead of
    /// rendering
    #[arg(long, value_name = "X,Y,I", help_heading = "Reports", value_parser = numbers::sample_path)]
    pub trace: Option<SamplePath>,
}

impl RenderArguments {
    /// The scene and the rendering requested.
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

    /// The outputs in addition to the picture: by kinds, and the light of classes of paths.
    pub fn beside(&self) -> (Vec<Aov>, Vec<PathClass>) {
        let (mut aovs, classes) = split(&self.outputs.aov);
        aovs.extend(self.denoise.denoise.map(|_| Aov::Denoised));
        (aovs, classes)
    }

    /// The job to render.
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

    /// The indices of a pixel's samples, at most.
    pub fn range(&self) -> Range<u32> {
        let endless = self.time.is_some() || self.target_error.is_some();
        let spp = self.spp.unwrap_or(if endless { u32::MAX } else { 64 });
        self.samples.clone().unwrap_or(0..spp)
    }

    /// Checks that there are enough samples to denoise, if requested.
    pub fn check_denoise(&self) -> Result<(), Failure> {
        let message = match self.denoise.denoise {
            Some(_) if self.samples.is_some() => {
                "--samples renders a part of a picture, but --denoise needs all samples".to_owned()
            }
            Some(_) if (self.range().len() as u32) < LEAST => format!(
                "--denoise needs --spp {LEAST} or more: each quarter of the samples makes a picture"
            ),
            _ => return Ok(()),
        };
        Err(Failure::Usage(message))
    }

    /// Renders the job on all named devices, else on `target`.
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

    /// The viewers, who may set `stop`.
    pub fn viewers(&self, doors: Doors, stop: &Arc<AtomicBool>) -> Result<Viewers, Failure> {
        let [left, top, ..] = self.view.crop.unwrap_or_default();
        doors.open(&self.scene()?.name(), [left, top], stop)
    }

    /// The default outputs.
    pub fn default_outputs(&self) -> Result<Vec<Destination>, Failure> {
        let stem = self.scene()?.stem().ok_or_else(|| {
            Failure::Usage(
                "the scene has no file name to derive the pictures' names from: use -o FILE"
                    .to_owned(),
            )
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

    /// The conditions that end the rendering earlier.
    pub fn until(&self) -> Until {
        Until {
            seconds: self.time,
            rel_mse: self.target_error,
        }
    }

    /// The scene.
    pub fn scene(&self) -> Result<&Source, Failure> {
        self.scene
            .as_ref()
            .ok_or_else(|| Failure::Usage("a scene file is missing".to_owned()))
    }

    /// The device that traces one path: the requested one, or the best Vulkan device even if another is faster.
    pub fn target(&self) -> Target {
        match &self.device {
            None => Target::Vulkan(Selector::Best),
            Some(Devices::One(target)) => target.clone(),
            Some(Devices::Several(targets)) => targets[0].clone(),
        }
    }

    /// The device that renders the job, and the reason if the job decides.
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

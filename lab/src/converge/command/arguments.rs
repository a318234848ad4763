//! Every flag of `vkpt converge`, with its help.

use std::path::PathBuf;

use super::vary::{Vary, vary};
use crate::cli::destination::Destination;
use crate::cli::exit::Failure;
use crate::cli::job::Request;
use crate::cli::numbers;
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values;
use crate::cli::view::ViewArguments;
use crate::converge::HALVES;
use vkpt::gpu::Selector;
use vkpt::render::Target;

const AFTER_HELP: &str = "\
Exit codes:
    0  measured, whatever was found: that pictures do not converge to the reference is a warning,
       and `converges` is false in --json
    1  rendering failed, by an error of the device or in a check of the samples
    2  the command line is wrong
    3  the scene, one of its meshes or the reference is wrong; nothing was written
    4  there is no such Vulkan device, or none at all
    5  a file or stdout could not be written
    6  there is not enough memory
  130  interrupted by ctrl-c; what was measured by then is told
  143  the same by SIGTERM, 129 by SIGHUP

Examples:
  vkpt converge scene.txt --time 60                      error against seconds
  vkpt converge scene.txt --vary connect=mis,light,bsdf  which of the three is best?
  vkpt converge scene.txt --reference other.exr          judged by another program's picture
  vkpt converge scene.txt --html report.html             a page with plot and pictures";

/// What is to be measured.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct ConvergeArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    /// The most seconds of sampling, of all replicates and variants together; a step that would not
    /// fit is not begun, which may leave up to half. Compiling, judging and the reference come on top
    #[arg(long, value_name = "S", help_heading = EXPERIMENT, default_value = "60", value_parser = numbers::seconds)]
    pub time: f64,

    /// Independent renderings of each variant, 2 to 1000; three or more tell whether they converge
    /// to the reference
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "8", value_parser = replicates)]
    pub replicates: u32,

    /// The most samples per pixel
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "1048576")]
    #[arg(value_parser = numbers::whole(1))]
    pub spp: u32,

    /// Render with each of these values of a setting, such as connect=mis,light; repeated, with all
    /// combinations. Any of the settings below, or denoise=off,nlm,oidn, seconds of denoising counted;
    /// the first is what the others are compared with
    #[arg(long, value_name = "NAME=VALUE,…", help_heading = EXPERIMENT, value_parser = vary)]
    pub vary: Vec<Vary>,

    /// The library of Open Image Denoise, for --vary denoise=oidn, or its folder [default: as of vkpt
    /// SCENE --denoise]
    #[arg(long, value_name = "PATH", help_heading = EXPERIMENT)]
    pub oidn: Option<PathBuf>,

    /// The picture to judge by: EXR, HDR or PNG, with the standard errors in NAME-stderr.exr beside
    /// it where that is there [default: two of vkpt's own, each rendered for half of --time]
    #[arg(long, value_name = "FILE", help_heading = EXPERIMENT)]
    pub reference: Option<PathBuf>,

    /// Stops by which the pictures are brightened before FLIP looks at them as PNGs, and those of
    /// --html
    #[arg(long, value_name = "EV", help_heading = EXPERIMENT, default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Seed of the first replicate; the others have those that follow
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "0")]
    #[arg(value_parser = numbers::whole(0))]
    pub seed: u32,

    #[command(flatten, next_help_heading = EXPERIMENT)]
    pub view: ViewArguments,

    /// A Vulkan device by its index or part of its name, or the reference renderer: cpu-f64,
    /// cpu-f32 [default: the best Vulkan device]
    #[arg(long, value_name = "DEVICE", help_heading = EXPERIMENT, value_parser = values::device)]
    device: Option<Target>,

    /// Write every figure, with those of each replicate; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub json: Option<Destination>,

    /// Write a line for each variant and step; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub csv: Option<Destination>,

    /// Write a plot of error over seconds, log–log, with intervals; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub svg: Option<Destination>,

    /// Write a page with all of it, and the pictures: one file that needs no network; - for
    /// stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub html: Option<Destination>,

    /// No progress and no table, only warnings and errors
    #[arg(long, help_heading = REPORTS)]
    pub quiet: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

const EXPERIMENT: &str = "Experiment";
const REPORTS: &str = "Reports";

impl ConvergeArguments {
    /// The scene and what is to be rendered of it by the settings of the command line.
    pub fn request(&self) -> Request<'_> {
        self.view
            .request(&self.scene, &self.settings, self.spp, self.seed)
    }

    /// What shall render.
    pub fn target(&self) -> Target {
        self.device
            .clone()
            .unwrap_or(Target::Vulkan(Selector::Best))
    }

    /// One a replicate.
    pub fn seeds(&self) -> Result<Vec<u32>, Failure> {
        let last = self.seed.checked_add(self.replicates - 1);
        match last.filter(|&last| last < HALVES[0]) {
            Some(last) => Ok((self.seed..=last).collect()),
            None => Err(Failure::Usage(format!(
                "--seed {} is too large: its replicates would have the seeds of the reference",
                self.seed
            ))),
        }
    }
}

fn replicates(text: &str) -> Result<u32, String> {
    match text.parse::<u32>() {
        Ok(1) => Err("one replicate tells nothing of chance: 2 or more are needed".to_owned()),
        Ok(n @ 2..=1000) => Ok(n),
        _ => Err("must be a whole number from 2 to 1000".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replicates_are_several() {
        assert_eq!((replicates("2"), replicates("1000")), (Ok(2), Ok(1000)));
        assert!(replicates("1").is_err_and(|e| e.contains("one replicate")));
        for wrong in ["0", "1001", "-3", "2.5", ""] {
            assert!(replicates(wrong).is_err(), "{wrong}");
        }
    }
}

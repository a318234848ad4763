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
    0  measured; if pictures do not converge to the reference, a warning is printed and `converges`
       is false in --json
    1  rendering failed (device error, or a failed check of the samples)
    2  the command line is wrong
    3  the scene, one of its meshes or the reference is wrong; nothing was written
    4  no Vulkan device, or none that matches --device
    5  a file or stdout could not be written
    6  not enough memory
  130  interrupted by ctrl-c; the steps measured by then are reported
  143  interrupted by SIGTERM; 129 by SIGHUP

Examples:
  vkpt converge scene.txt --time 60                      error over seconds
  vkpt converge scene.txt --vary connect=mis,light,bsdf  compare three settings
  vkpt converge scene.txt --reference other.exr          use another program's picture
  vkpt converge scene.txt --html report.html             write a page with plot and pictures";

/// The experiment.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct ConvergeArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    /// Sample for at most this many seconds, all replicates and variants together. A step that would
    /// not fit is not started, so up to half may remain unused; compiling, judging and the reference
    /// take extra time
    #[arg(long, value_name = "S", help_heading = EXPERIMENT, default_value = "60", value_parser = numbers::seconds)]
    pub time: f64,

    /// Independent renderings of each variant, 2 to 1000; testing whether they converge to the
    /// reference takes three or more
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "8", value_parser = replicates)]
    pub replicates: u32,

    /// Maximum samples per pixel
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "1048576")]
    #[arg(value_parser = numbers::whole(1))]
    pub spp: u32,

    /// Render with each of these values of a setting, such as connect=mis,light; if repeated, with all
    /// combinations. NAME is any setting below, or denoise with the values off, nlm and oidn, whose
    /// seconds count. The others are compared with the first
    #[arg(long, value_name = "NAME=VALUE,…", help_heading = EXPERIMENT, value_parser = vary)]
    pub vary: Vec<Vary>,

    /// Library of Open Image Denoise for --vary denoise=oidn, or its folder [default: as for vkpt SCENE
    /// --denoise]
    #[arg(long, value_name = "PATH", help_heading = EXPERIMENT)]
    pub oidn: Option<PathBuf>,

    /// Picture to compare with: EXR, HDR or PNG; the standard errors in NAME-stderr.exr next to it are
    /// used if present [default: two pictures that vkpt renders, each for half of --time]
    #[arg(long, value_name = "FILE", help_heading = EXPERIMENT)]
    pub reference: Option<PathBuf>,

    /// Brighten the pictures by this many stops for FLIP, which compares them as PNGs, and for --html
    #[arg(long, value_name = "EV", help_heading = EXPERIMENT, default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Seed of the first replicate; the others use the next numbers
    #[arg(long, value_name = "N", help_heading = EXPERIMENT, default_value = "0")]
    #[arg(value_parser = numbers::whole(0))]
    pub seed: u32,

    #[command(flatten, next_help_heading = EXPERIMENT)]
    pub view: ViewArguments,

    /// Vulkan device, by index or part of its name, or the reference renderer: cpu-f64 or cpu-f32
    /// [default: the best Vulkan device]
    #[arg(long, value_name = "DEVICE", help_heading = EXPERIMENT, value_parser = values::device)]
    device: Option<Target>,

    /// Write every figure as JSON, including each replicate's; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub json: Option<Destination>,

    /// Write CSV, a line for each variant and step; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub csv: Option<Destination>,

    /// Write an SVG plot of error over seconds, log–log, with intervals; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub svg: Option<Destination>,

    /// Write a self-contained HTML page with figures, plot and pictures; - for stdout
    #[arg(long, value_name = "FILE", help_heading = REPORTS)]
    pub html: Option<Destination>,

    /// Print only warnings and errors: no progress, no table
    #[arg(long, help_heading = REPORTS)]
    pub quiet: bool,

    #[command(flatten)]
    pub settings: SettingArguments,
}

const EXPERIMENT: &str = "Experiment";
const REPORTS: &str = "Reports";

impl ConvergeArguments {
    /// The scene and the rendering requested, with the settings of the command line.
    pub fn request(&self) -> Request<'_> {
        self.view
            .request(&self.scene, &self.settings, self.spp, self.seed)
    }

    /// The device that renders.
    pub fn target(&self) -> Target {
        self.device
            .clone()
            .unwrap_or(Target::Vulkan(Selector::Best))
    }

    /// A seed for each replicate.
    pub fn seeds(&self) -> Result<Vec<u32>, Failure> {
        let last = self.seed.checked_add(self.replicates - 1);
        match last.filter(|&last| last < HALVES[0]) {
            Some(last) => Ok((self.seed..=last).collect()),
            None => Err(Failure::Usage(format!(
                "--seed {} is too large: its replicates would use the seeds of the reference; use {} or less",
                self.seed,
                HALVES[0] - self.replicates
            ))),
        }
    }
}

fn replicates(text: &str) -> Result<u32, String> {
    match text.parse::<u32>() {
        Ok(1) => Err("one replicate gives no interval: 2 or more are needed".to_owned()),
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

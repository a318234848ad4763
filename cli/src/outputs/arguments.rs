//! The flags of what a picture is written to.

use vkpt::image::Format;
use vkpt_lab::cli::beside::{Beside, BesideParser};
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::numbers;
use vkpt_lab::cli::values::choice;

/// Which files are written, and what beside them.
#[derive(clap::Args, Debug)]
pub struct OutputArguments {
    /// Picture to write: .png (sRGB), .hdr (linear, RGBE) or .exr (linear, f32), or - for stdout; or
    /// .vkpt, from which --resume goes on and which vkpt merge joins; may be repeated [default: the
    /// scene's name with .png and .exr, in the working directory]
    #[arg(short, long = "output", value_name = "FILE", help_heading = "Picture")]
    pub output: Vec<Destination>,

    /// Format of pictures whose name does not tell it, and of stdout: png, hdr or exr
    #[arg(long, value_name = "FORMAT", help_heading = "Picture")]
    #[arg(value_parser = choice::<Format>(), hide_possible_values = true)]
    pub format: Option<Format>,

    /// Write what else is known of the pixels. stderr: standard errors of the mean, to
    /// NAME-stderr.exr; and as layers of the picture's own EXR, of what is seen first: albedo,
    /// normal, depth, position, the lines of shape and material, samples; albedo* and normal* of
    /// what mirrors and smooth glass show; light:PATTERN, the light of a class of paths, as
    /// light:ED.*L: E, the eye, D (diffuse), G (rough) or S (smooth) for each surface, L, the light
    #[arg(
        long,
        value_name = "WHAT",
        help_heading = "Picture",
        value_delimiter = ','
    )]
    #[arg(value_parser = BesideParser)]
    pub aov: Vec<Beside>,

    /// Stops by which .png is brightened; negative: darkened
    #[arg(long, value_name = "EV", help_heading = "Picture", default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Write what the rendering did and how long it took; - for stdout
    #[arg(long, value_name = "FILE", help_heading = "Reports")]
    pub json: Option<Destination>,

    /// No progress and no summary, only warnings and errors
    #[arg(long, help_heading = "Reports")]
    pub quiet: bool,
}

//! The flags of a picture's outputs.

use vkpt::image::Format;
use vkpt_lab::cli::beside::{Beside, BesideParser};
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::numbers;
use vkpt_lab::cli::values::choice;

/// The files to write.
#[derive(clap::Args, Debug)]
pub struct OutputArguments {
    /// Picture to write: .png (sRGB), .hdr (linear, RGBE) or .exr (linear, f32), or - for stdout; or a
    /// .vkpt file, for --resume and vkpt merge; may be repeated [default: the scene's name with .png
    /// and .exr, in the working directory]
    #[arg(short, long = "output", value_name = "FILE", help_heading = "Picture")]
    pub output: Vec<Destination>,

    /// Format of stdout and of pictures without a known file name extension: png, hdr or exr
    #[arg(long, value_name = "FORMAT", help_heading = "Picture")]
    #[arg(value_parser = choice::<Format>(), hide_possible_values = true)]
    pub format: Option<Format>,

    /// Also write these. stderr: standard errors of the mean, to NAME-stderr.exr. Layers in the
    /// picture's EXR: albedo, normal, depth, position, shape, material (as scene lines) of the first
    /// surface; samples; albedo* and normal* of the surface seen in mirrors and through smooth glass;
    /// light:PATTERN, the light of a class of paths, such as light:ED.*L: E for the eye, D (diffuse),
    /// G (rough) or S (smooth) for each surface, L for the light
    #[arg(
        long,
        value_name = "LAYERS",
        help_heading = "Picture",
        value_delimiter = ','
    )]
    #[arg(value_parser = BesideParser)]
    pub aov: Vec<Beside>,

    /// Brighten the .png by this many stops; negative values darken it
    #[arg(long, value_name = "EV", help_heading = "Picture", default_value = "0")]
    #[arg(value_parser = numbers::exposure)]
    pub exposure: f64,

    /// Write a report as JSON: seconds, rates, error, device, settings; - for stdout
    #[arg(long, value_name = "FILE", help_heading = "Reports")]
    pub json: Option<Destination>,

    /// Print only warnings and errors: no progress, no summary
    #[arg(long, help_heading = "Reports")]
    pub quiet: bool,
}

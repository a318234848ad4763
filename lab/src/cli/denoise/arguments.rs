//! The flags of denoising.

use std::path::PathBuf;

use crate::cli::values::choice;
use vkpt::report::names::Named;

/// What is to denoise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Open Image Denoise where its library is found, else non-local means.
    Auto,
    Oidn,
    Nlm,
}

impl Named for By {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Auto, "auto"),
        (Self::Oidn, "oidn"),
        (Self::Nlm, "nlm"),
    ];
}

/// Whether to denoise, and by what.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct DenoiseArguments {
    /// Also write denoised pictures, NAME-denoised beside each: by Open Image Denoise (oidn), if its
    /// library is there, else by vkpt's own non-local means (nlm). They have an error of their own,
    /// for which the last lines give a bound
    #[arg(
        long,
        value_name = "BY",
        help_heading = "Picture",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "auto"
    )]
    #[arg(value_parser = choice::<By>(), hide_possible_values = true)]
    pub denoise: Option<By>,

    /// The library of Open Image Denoise 2, or its folder [default: VKPT_OIDN, or where the system's
    /// loader, then Python's packages (pip install pyoidn) have it]
    #[arg(long, value_name = "PATH", help_heading = "Picture")]
    pub oidn: Option<PathBuf>,
}

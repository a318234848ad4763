//! The flags of denoising.

use std::path::PathBuf;

use crate::cli::values::choice;
use vkpt::report::names::Named;

/// The denoiser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Open Image Denoise if its library is found, else non-local means.
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

/// The flags of denoising.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct DenoiseArguments {
    /// Also write denoised pictures, NAME-denoised next to each, by Open Image Denoise (oidn) or
    /// vkpt's own non-local means (nlm) [default BY: oidn if its library is found, else nlm]. The last
    /// lines of output bound their error
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

    /// Library of Open Image Denoise 2, or its folder [default: VKPT_OIDN, then the system loader's
    /// paths, then Python's packages (pip install pyoidn)]
    #[arg(long, value_name = "PATH", help_heading = "Picture")]
    pub oidn: Option<PathBuf>,
}

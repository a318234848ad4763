//! The flags of the live view.

use crate::live::Address;

/// The viewers of a growing picture.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct LiveArguments {
    /// Serve a page that shows the picture as it grows and can stop the rendering, on 127.0.0.1 only,
    /// at this port [default: a free port, which is printed]
    #[arg(
        long,
        value_name = "PORT",
        help_heading = "Live view",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "0"
    )]
    #[arg(value_parser = port)]
    pub view: Option<u16>,

    /// Send the picture as it grows to the viewer tev at this address [default port: 14158]
    #[arg(long, value_name = "HOST[:PORT]", help_heading = "Live view")]
    pub tev: Option<Address>,
}

/// 0 is any free port.
fn port(text: &str) -> Result<u16, String> {
    text.parse().map_err(|_| {
        "must be a port, a whole number from 1 to 65535, or 0 for a free one".to_owned()
    })
}

//! Every flag of `vkpt export`, with its help.

use crate::cli::destination::Destination;
use crate::cli::job::Request;
use crate::cli::settings::SettingArguments;
use crate::cli::source::Source;
use crate::cli::values::{Peer, choice};
use crate::cli::view::ViewArguments;

const EXIT_CODES: &str = "\
Exit codes:
    0  written
    2  the command line is wrong, or a flag has no equal in the other renderer
    3  the scene or one of its meshes is wrong, or has no equal there; nothing was written
    5  a file or stdout could not be written
    6  there is not enough memory";

/// What is to be written for whom.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct ExportArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    /// The renderer that is to read it: mitsuba, version 3
    #[arg(long, value_name = "RENDERER", value_parser = choice::<Peer>(), hide_possible_values = true)]
    pub to: Peer,

    /// File to write, meshes beside it as NAME-LINE.ply; - for stdout [default: the scene's name with
    /// .xml, in the working directory]
    #[arg(short, long = "output", value_name = "FILE")]
    pub output: Option<Destination>,

    #[command(flatten)]
    pub view: ViewArguments,

    #[command(flatten)]
    pub settings: SettingArguments,
}

impl ExportArguments {
    /// The scene and what would be rendered of it.
    pub fn request(&self) -> Request<'_> {
        // What is written depends on neither samples nor seed.
        self.view.request(&self.scene, &self.settings, 1, 0)
    }
}

//! Every flag of `vkpt export`, with its help.

use super::peer::Peer;
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::job::Request;
use vkpt_lab::cli::settings::SettingArguments;
use vkpt_lab::cli::source::Source;
use vkpt_lab::cli::values::choice;
use vkpt_lab::cli::view::ViewArguments;

const EXIT_CODES: &str = "\
Exit codes:
    0  written
    2  the command line is wrong, or a flag has no equal in the other renderer
    3  the scene or one of its meshes is wrong, or has no equal there; nothing was written
    5  a file or stdout could not be written
    6  there is not enough memory

Examples:
  vkpt export scene.txt --to mitsuba       scene.xml, and its meshes as scene-LINE.ply
  vkpt export scene.txt --to pbrt          scene.pbrt; what that has another model of is warned of
  vkpt export scene.txt --to gltf          scene.glb, in one file
  vkpt export scene.txt --to gltf -o out/scene.gltf";

/// What is to be written for whom.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct ExportArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    /// Who is to read it: mitsuba (version 3), pbrt (version 4), or gltf (2.0) for many
    #[arg(long, value_name = "RENDERER", value_parser = choice::<Peer>(), hide_possible_values = true)]
    pub to: Peer,

    /// File to write, meshes beside it as NAME-LINE.ply; - for stdout [default: the scene's name with
    /// .xml, .pbrt or .glb, in the working directory]
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

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
    2  the command line is wrong, or the other renderer has no equivalent of a flag
    3  the scene or one of its meshes is wrong, or has no equivalent there; nothing was written
    5  a file or stdout could not be written
    6  not enough memory

Examples:
  vkpt export scene.txt --to mitsuba       scene.xml, and its meshes as scene-LINE.ply
  vkpt export scene.txt --to pbrt          scene.pbrt; gives warnings where pbrt's model differs
  vkpt export scene.txt --to gltf          scene.glb, in one file
  vkpt export scene.txt --to gltf -o out/scene.gltf";

/// The flags of an export.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct ExportArguments {
    /// The scene file, text or glTF, or - for stdin
    pub scene: Source,

    /// Renderer or format to write for: mitsuba (version 3), pbrt (version 4) or gltf (2.0)
    #[arg(long, value_name = "RENDERER", value_parser = choice::<Peer>(), hide_possible_values = true)]
    pub to: Peer,

    /// File to write, with meshes next to it as NAME-LINE.ply; - for stdout [default: the scene's name
    /// with .xml, .pbrt or .glb, in the working directory]
    #[arg(short, long = "output", value_name = "FILE")]
    pub output: Option<Destination>,

    #[command(flatten)]
    pub view: ViewArguments,

    #[command(flatten)]
    pub settings: SettingArguments,
}

impl ExportArguments {
    /// The scene and the rendering to export.
    pub fn request(&self) -> Request<'_> {
        // The export depends on neither samples nor seed.
        self.view.request(&self.scene, &self.settings, 1, 0)
    }
}

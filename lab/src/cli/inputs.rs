//! Files that a command reads and must not overwrite.

use std::path::Path;

use same_file::Handle;

use super::destination::Destination;
use super::exit::Failure;
use super::identity;
use super::source::Source;
use vkpt::scene::{Geometry, Scene};

/// A file that is read.
pub struct Input {
    what: &'static str,
    source: Source,
}

impl Input {
    /// A file and its role, such as `the picture`.
    pub fn new(what: &'static str, path: &Path) -> Self {
        let source = Source::File(path.to_owned());
        Self { what, source }
    }

    /// The file of a scene, and those of its meshes.
    pub fn of_scene(source: &Source, scene: &Scene) -> Vec<Self> {
        let scene_file = Self {
            what: "the scene",
            source: source.clone(),
        };
        let meshes = scene.shapes.iter().filter_map(|s| match &s.geometry {
            Geometry::Mesh(mesh) => Some([&mesh.path].into_iter().chain(&mesh.files)),
            _ => None,
        });
        let files = meshes.flatten();
        let files = files.map(|path| Self::new("a mesh of the scene", path));
        let surroundings = (scene.surroundings.as_ref())
            .map(|s| Self::new("the picture of the scene's surroundings", &s.path));
        [scene_file]
            .into_iter()
            .chain(files)
            .chain(surroundings)
            .collect()
    }

    fn identity(&self) -> Option<Handle> {
        match &self.source {
            Source::Stdin => identity::of_stdin(),
            Source::File(path) => identity::of(path),
            Source::Text(_) => None,
        }
    }
}

/// Checks that no output would overwrite an input, under any name.
pub fn spare<'a>(
    inputs: &[Input],
    outputs: impl IntoIterator<Item = &'a Destination>,
) -> Result<(), Failure> {
    for to in outputs {
        let Some(file) = to.identity() else { continue };
        let is_it = |input: &&Input| input.identity().is_some_and(|own| own == file);
        if let Some(Input { what, source }) = inputs.iter().find(is_it) {
            let name = match source.name() {
                same if same == to.to_string() => String::new(),
                other => format!(" {other}"),
            };
            return Err(Failure::Usage(format!(
                "{to} would be overwritten: it is {what}{name}; give the output another name"
            )));
        }
    }
    Ok(())
}

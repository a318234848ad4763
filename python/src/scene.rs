//! The scene that a program passes.

use std::path::PathBuf;

use pyo3::prelude::*;
use vkpt_lab::cli::source::Source;

/// A path, or a text.
#[derive(FromPyObject)]
pub enum Scene {
    #[pyo3(transparent)]
    File(PathBuf),
    /// In a tuple, because a text would otherwise be read as a path.
    Text((String,)),
}

impl From<Scene> for Source {
    fn from(scene: Scene) -> Self {
        match scene {
            Scene::File(path) => Self::File(path),
            Scene::Text((text,)) => Self::Text(text),
        }
    }
}

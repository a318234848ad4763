//! The scene that a program means.

use std::path::PathBuf;

use pyo3::prelude::*;
use vkpt_lab::cli::source::Source;

/// A path, or a text.
#[derive(FromPyObject)]
pub enum Scene {
    #[pyo3(transparent)]
    File(PathBuf),
    /// A tuple of one, so that a text is not taken for a path.
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

//! `vkpt SCENE`, into memory.

use std::ffi::OsString;

use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use vkpt_cli::parsed;
use vkpt_cli::{RenderArguments, rendered};

use crate::caller::call;
use crate::failure::raise;
use crate::picture::Picture;
use crate::scene::Scene;

/// Renders a scene; `words` are flags of `vkpt SCENE`.
#[pyfunction]
pub fn render(
    py: Python,
    scene: Scene,
    words: Vec<OsString>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Picture> {
    let arguments = arguments(scene, words).map_err(|failure| raise(py, failure))?;
    let made = call(py, progress, move || rendered(&arguments, &mut |_| {}))?;
    match made.map_err(|failure| raise(py, failure))? {
        Some(rendered) => Picture::new(py, rendered),
        None => Err(PyKeyboardInterrupt::new_err(())),
    }
}

/// The arguments of a rendering of the scene, from flags of `vkpt SCENE`.
pub fn arguments(
    scene: Scene,
    mut words: Vec<OsString>,
) -> Result<RenderArguments, vkpt_lab::cli::exit::Failure> {
    words.push("-".into());
    let mut arguments = parsed::<RenderArguments>(words)?;
    arguments.scene = Some(scene.into());
    Ok(arguments)
}

//! `vkpt converge`, into memory.

use std::ffi::OsString;

use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use vkpt_cli::parsed;
use vkpt_lab::converge::command::{ConvergeArguments, converged};

use crate::caller::call;
use crate::failure::raise;
use crate::scene::Scene;

/// Measures how fast a scene converges; `words` are flags of `vkpt converge`. Returns the contents of `--json`.
#[pyfunction]
pub fn converge(
    py: Python,
    scene: Scene,
    mut words: Vec<OsString>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    words.push("-".into());
    let mut arguments = parsed::<ConvergeArguments>(words).map_err(|failure| raise(py, failure))?;
    arguments.scene = scene.into();
    let made = call(py, progress, move || converged(&arguments))?;
    match made.map_err(|failure| raise(py, failure))? {
        Some(record) => serde_json::to_string(&record)
            .map_err(|error| PyRuntimeError::new_err(error.to_string())),
        None => Err(PyKeyboardInterrupt::new_err(())),
    }
}

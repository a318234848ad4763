//! A failure of a command as an exception of `vkpt.errors`.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use vkpt::scene::Diagnostic;
use vkpt_lab::cli::exit::Failure;

/// The exception: its text is the command line's, and its attributes are parts of it.
pub fn raise(py: Python, failure: Failure) -> PyErr {
    exception(py, &failure).unwrap_or_else(|error| error)
}

fn exception(py: Python, failure: &Failure) -> PyResult<PyErr> {
    let class = py.import("vkpt.errors")?.getattr(class(failure))?;
    let messages = failure.messages();
    let text = match failure {
        Failure::Scene(errors) => {
            let drawn: String = errors.diagnostics.iter().map(Diagnostic::drawn).collect();
            format!("{errors}\n{drawn}").trim_end().to_owned()
        }
        _ => messages.join("\n"),
    };
    let diagnostics = match failure {
        Failure::Scene(errors) => &errors.diagnostics[..],
        _ => &[],
    };
    let diagnostics: PyResult<Vec<_>> = diagnostics.iter().map(|d| diagnostic(py, d)).collect();
    let exception = class.call1((text, messages, failure.code(), diagnostics?))?;
    Ok(PyErr::from_value(exception))
}

/// The class's name.
fn class(failure: &Failure) -> &'static str {
    match failure.code() {
        2 => "ArgumentError",
        3 => "SceneError",
        5 => "FileError",
        6 => "OutOfMemory",
        _ => "DeviceError",
    }
}

fn diagnostic<'py>(py: Python<'py>, of: &Diagnostic) -> PyResult<Bound<'py, PyAny>> {
    let fields = PyDict::new(py);
    fields.set_item("severity", format!("{:?}", of.severity).to_lowercase())?;
    fields.set_item("message", &of.message)?;
    fields.set_item("file", of.file())?;
    fields.set_item("line", of.place.map(|place| place.line))?;
    fields.set_item("column", of.place.map(|place| place.column))?;
    fields.set_item("culprit", of.culprit())?;
    fields.set_item("label", &of.label)?;
    fields.set_item("help", &of.help)?;
    let class = py.import("vkpt.errors")?.getattr("Diagnostic")?;
    class.call((), Some(&fields))
}

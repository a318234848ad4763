//! vkpt as a Python module: the package in `vkpt/` is the public interface and calls this one.
//!
//! Arguments arrive as the words of a command line and go through the command line's own parser, so names, defaults, ranges
//! and messages are the same.

mod arrays;
mod caller;
mod compare;
mod converge;
mod failure;
mod growing;
mod picture;
mod render;
mod scene;

use std::ffi::OsString;

use pyo3::prelude::*;

/// The native half of the module `vkpt`.
#[pymodule]
mod _vkpt {
    use std::collections::HashMap;

    use super::*;
    use vkpt_cli::RenderArguments;
    use vkpt_cli::flags;
    use vkpt_lab::converge::command::ConvergeArguments;

    #[pymodule_export]
    use super::{
        compare::{compare, read},
        converge::converge,
        growing::Growing,
        picture::{ErrorAt, Picture},
        render::render,
    };

    /// Runs a command line, the program's name first; returns its exit code.
    #[pyfunction]
    fn run(py: Python, words: Vec<OsString>) -> u8 {
        py.detach(|| vkpt_cli::run(words.into_iter()))
    }

    /// The flags of `vkpt SCENE` and of `vkpt converge`, and whether each is a switch.
    #[pyfunction]
    fn command_flags() -> HashMap<&'static str, HashMap<String, bool>> {
        HashMap::from([
            ("render", flags::<RenderArguments>().into_iter().collect()),
            (
                "converge",
                flags::<ConvergeArguments>().into_iter().collect(),
            ),
        ])
    }

    #[pymodule_init]
    fn init(module: &Bound<PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}

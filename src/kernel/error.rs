//! Errors of a kernel. These are errors of the project, not of its user, except when a driver refuses a kernel.

use std::fmt;

/// A kernel that could not be composed or compiled.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum KernelError {
    #[error("{asked_by} uses {name}, but shaders/{name}.glsl does not exist")]
    UnknownFile { name: String, asked_by: String },
    #[error("{asked_by} uses the slot <{slot}>, which is not filled")]
    UnknownSlot { slot: String, asked_by: String },
    #[error("shader files use each other in a cycle: {}", chain.join(" → "))]
    Cycle { chain: Vec<String> },
    #[error("the kernel does not use the file {name}, so replacing it has no effect")]
    Unused { name: String },
    #[error("GLSL: {}", list(.0))]
    Glsl(Vec<Culprit>),
    #[error("invalid kernel: {message}{}", list(.culprits))]
    Invalid {
        message: String,
        culprits: Vec<Culprit>,
    },
    #[error("the results of these depend on the driver: use the functions of shaders/math instead: {}", list(.0))]
    DriverMaths(Vec<Culprit>),
    #[error(
        "the GLSL compiler (naga) panicked: {0}; a component or member passed as out or inout can cause this"
    )]
    Panic(String),
    #[error("SPIR-V: {0}")]
    Spirv(String),
}

/// A place in a shader file, and the error there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Culprit {
    pub message: String,
    /// The file's path below `shaders/`, or the name of a slot or of the prelude.
    pub file: String,
    /// From 1, in that file.
    pub line: usize,
    /// The line itself.
    pub text: String,
}

impl fmt::Display for Culprit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            message,
            file,
            line,
            text,
        } = self;
        write!(
            f,
            "{message}\n  --> {file}:{line}\n   | {}",
            text.trim_end()
        )
    }
}

fn list(culprits: &[Culprit]) -> String {
    culprits.iter().map(|c| format!("\n{c}")).collect()
}

//! Kernels that ask what a driver makes of what [`compile`](super::compile) refuses or marks. Only `doctor` uses
//! them (`tests/library/architecture.rs`): no picture may depend on such a kernel.

use super::compile::{caught, module_edited, spirv, words};
use super::composed::Composed;
use super::error::KernelError;
use super::spirv::Spirv;
use super::{no_contraction, workgroup_barrier};

/// What a driver may make of float operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Each as it is written: `NoContraction`, as in every kernel that renders.
    AsWritten,
    /// What it likes: products and sums in one, rewritten algebra.
    DriversChoice,
}

/// Compiles a composed kernel with whatever GLSL's own functions and barriers it calls.
///
/// # Errors
/// As [`compile`](super::compile).
pub fn compile(kernel: &Composed, arithmetic: Arithmetic) -> Result<Spirv, KernelError> {
    caught(|| {
        let (module, info) = module_edited(kernel, workgroup_barrier::widen)?;
        let words = words(&module, &info)?;
        let words = match arithmetic {
            Arithmetic::AsWritten => no_contraction::decorate(&words)?,
            Arithmetic::DriversChoice => words,
        };
        Ok(spirv(words, &module))
    })
}

//! Kernels that test how a driver treats operations that [`compile`](super::compile) refuses or marks. Only `doctor`
//! uses them (`tests/library/architecture/`): no picture may depend on such a kernel.

use super::compile::{caught, module_edited, spirv, words};
use super::composed::Composed;
use super::error::KernelError;
use super::spirv::Spirv;
use super::{no_contraction, workgroup_barrier};

/// How a driver may treat float operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Each as it is written: `NoContraction`, as in every kernel that renders.
    AsWritten,
    /// Freely: fused products and sums, rewritten algebra.
    DriversChoice,
}

/// Compiles a composed kernel with any of GLSL's own functions and barriers.
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

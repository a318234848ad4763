//! GLSL → SPIR-V, by naga.

use std::panic::{AssertUnwindSafe, catch_unwind};

use naga::compact::{KeepUnused, compact};
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
use naga::{Module, ShaderStage, WithSpan, back, front};

use super::composed::Composed;
use super::error::KernelError;
use super::spirv::Spirv;
use super::{audit, no_contraction, single_store, uninitialised};

/// Compiles a composed kernel: functions that `main` does not reach are dropped, operations whose result a driver may
/// choose are refused, and every float operation is marked `NoContraction`.
///
/// # Errors
/// With file, line and text where naga knows the place; a panic of naga is caught.
pub fn compile(kernel: &Composed) -> Result<Spirv, KernelError> {
    caught(|| {
        let (module, info) = module(kernel)?;
        audit::refuse_driver_maths(&module, &info, kernel)?;
        let words = no_contraction::decorate(&words(&module, &info)?)?;
        Ok(spirv(words, &module))
    })
}

/// The words of a module, without needless variables; no operation is marked.
pub(super) fn words(module: &Module, info: &ModuleInfo) -> Result<Vec<u32>, KernelError> {
    let words = back::spv::write_vec(module, info, &options(), None)
        .map_err(|e| KernelError::Spirv(e.to_string()))?;
    single_store::forward(&uninitialised::strip_null_arrays(&words)?)
}

pub(super) fn spirv(words: Vec<u32>, module: &Module) -> Spirv {
    let size = module.entry_points[0].workgroup_size;
    Spirv::new(words, functions(module), size)
}

/// Parsed, compacted and valid.
pub(super) fn module(kernel: &Composed) -> Result<(Module, ModuleInfo), KernelError> {
    module_edited(kernel, |_| {})
}

/// The same for the result of `edit` on the parsed module.
pub(super) fn module_edited(
    kernel: &Composed,
    edit: impl FnOnce(&mut Module),
) -> Result<(Module, ModuleInfo), KernelError> {
    let mut module = parse(kernel)?;
    edit(&mut module);
    // An invalid module may not be compacted.
    validate(&module, kernel)?;
    compact(&mut module, KeepUnused::No);
    let info = validate(&module, kernel)?;
    Ok((module, info))
}

fn parse(kernel: &Composed) -> Result<Module, KernelError> {
    front::glsl::Frontend::default()
        .parse(
            &front::glsl::Options::from(ShaderStage::Compute),
            kernel.text(),
        )
        .map_err(|e| {
            let culprit = |e: &front::glsl::Error| {
                let start = e.meta.to_range().map_or(0, |r| r.start);
                kernel.culprit(start, e.kind.to_string())
            };
            KernelError::Glsl(e.errors.iter().map(culprit).collect())
        })
}

fn validate(module: &Module, kernel: &Composed) -> Result<ModuleInfo, KernelError> {
    Validator::new(ValidationFlags::all(), Capabilities::IMMEDIATES)
        .validate(module)
        .map_err(|e| invalid(&e, kernel))
}

fn invalid(error: &WithSpan<ValidationError>, kernel: &Composed) -> KernelError {
    let culprits = error
        .spans()
        .filter_map(|(span, label)| Some(kernel.culprit(span.to_range()?.start, label.clone())))
        .collect();
    KernelError::Invalid {
        message: with_causes(error.as_inner()),
        culprits,
    }
}

/// An error and all its causes, in one line.
fn with_causes(error: &dyn std::error::Error) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(e) = cause {
        message += &format!(": {e}");
        cause = e.source();
    }
    message
}

fn options() -> back::spv::Options<'static> {
    back::spv::Options {
        // 1.3 is Vulkan 1.1's, the first with storage buffers as a class of their own.
        lang_version: (1, 3),
        flags: back::spv::WriterFlags::empty(),
        // With bounding, 40 small loops took lavapipe 8 s to compile, without 10 ms.
        force_loop_bounding: false,
        // The kernels index within bounds; a check costs 3 to 16 %.
        bounds_check_policies: BoundsCheckPolicies {
            index: BoundsCheckPolicy::Unchecked,
            buffer: BoundsCheckPolicy::Unchecked,
            image_load: BoundsCheckPolicy::Unchecked,
            binding_array: BoundsCheckPolicy::Unchecked,
        },
        // No kernel divides integers by a number that may be 0.
        emit_int_div_checks: false,
        zero_initialize_workgroup_memory: back::spv::ZeroInitializeWorkgroupMemoryMode::None,
        ..Default::default()
    }
}

/// naga keeps GLSL's main as a function that the entry point calls.
fn functions(module: &Module) -> Vec<String> {
    module
        .functions
        .iter()
        .filter_map(|(_, f)| f.name.clone())
        .filter(|name| name != "main")
        .collect()
}

/// A panic of naga as an error. (Rust's own panic message still goes to stderr.)
pub(super) fn caught<T>(f: impl FnOnce() -> Result<T, KernelError>) -> Result<T, KernelError> {
    catch_unwind(AssertUnwindSafe(f)).unwrap_or_else(|panic| {
        let message = panic
            .downcast_ref::<&str>()
            .map(|s| (*s).to_owned())
            .or_else(|| panic.downcast_ref::<String>().cloned())
            .unwrap_or_else(|| "no message".into());
        Err(KernelError::Panic(message))
    })
}

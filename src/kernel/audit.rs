//! Refuses operations whose result Vulkan leaves to the driver.
//!
//! Vulkan 1.3, appendix "Precision and Operation of SPIR-V Instructions": `+ − ×` round correctly, `÷` is within 2.5
//! ulps and `√` inherits from it (both round correctly on CPU drivers); everything below may differ from driver to
//! driver by far more, or may be evaluated in any order, or may give either result for NaN and ±0.

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{BinaryOperator, Expression, Function, MathFunction, Module, ScalarKind};

use super::composed::Composed;
use super::error::{Culprit, KernelError};

/// An error that names every such operation in `module`.
pub(super) fn refuse_driver_maths(
    module: &Module,
    info: &ModuleInfo,
    kernel: &Composed,
) -> Result<(), KernelError> {
    let mut culprits = Vec::new();
    for (handle, function) in module.functions.iter() {
        look(module, function, &info[handle], kernel, &mut culprits);
    }
    for (i, entry) in module.entry_points.iter().enumerate() {
        look(
            module,
            &entry.function,
            info.get_entry_point(i),
            kernel,
            &mut culprits,
        );
    }
    if culprits.is_empty() {
        Ok(())
    } else {
        Err(KernelError::DriverMaths(culprits))
    }
}

fn look(
    module: &Module,
    function: &Function,
    info: &FunctionInfo,
    kernel: &Composed,
    culprits: &mut Vec<Culprit>,
) {
    // naga gives a built-in call no place of its own: its arguments, which come just before it, have one.
    let mut start = 0;
    for (handle, expression) in function.expressions.iter() {
        start = function
            .expressions
            .get_span(handle)
            .to_range()
            .map_or(start, |r| r.start);
        let kind = info[handle].ty.inner_with(&module.types).scalar_kind();
        // No kind: a pair of results in a struct, as for modf and frexp.
        let float = kind.is_none_or(|k| k == ScalarKind::Float);
        let name = match expression {
            Expression::Math { fun, .. } if float && !is_exact(*fun) => format!("{fun:?}"),
            Expression::Binary {
                op: BinaryOperator::Modulo,
                ..
            } if float => "mod".to_owned(),
            _ => continue,
        };
        culprits.push(kernel.culprit(start, name));
    }
}

/// Functions with one correct result, which every driver must give (`√`: see above).
fn is_exact(fun: MathFunction) -> bool {
    use MathFunction as M;
    matches!(fun, M::Abs | M::Floor | M::Ceil | M::Trunc | M::Sqrt)
}

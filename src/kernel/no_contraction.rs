//! Marks every float operation `NoContraction`, so that a driver computes it as written: no fused multiply-add, no
//! rewritten algebra. This makes kernel and CPU reference agree to the bit.

use super::error::KernelError;
use super::spirv::{HEADER, Instruction};

const OP_DECORATE: u32 = 71;
const DECORATION_NO_CONTRACTION: u32 = 42;

/// Float arithmetic (SPIR-V 1.3, section 3.32.13); the result is operand 1 of each.
///
/// FNegate, FAdd, FSub, FMul, FDiv, FRem, FMod, VectorTimesScalar … OuterProduct, Dot.
pub(super) fn is_float_arithmetic(opcode: u32) -> bool {
    matches!(opcode, 127 | 129 | 131 | 133 | 136 | 140 | 141 | 142..=148)
}

/// The module with the decorations added.
pub(super) fn decorate(module: &[u32]) -> Result<Vec<u32>, KernelError> {
    let mut decorations = Vec::new();
    for instruction in Instruction::walk(module) {
        let instruction = instruction?;
        if is_float_arithmetic(instruction.opcode()) {
            decorations.extend([
                3 << 16 | OP_DECORATE,
                instruction.operand(1),
                DECORATION_NO_CONTRACTION,
            ]);
        }
    }
    let at = annotations(module)?;
    Ok([&module[..at], &decorations, &module[at..]].concat())
}

/// Index of the word before which decorations may be inserted: the end of the debug section (SPIR-V 1.3, section 2.4).
fn annotations(module: &[u32]) -> Result<usize, KernelError> {
    let mut at = HEADER;
    for instruction in Instruction::walk(module) {
        let instruction = instruction?;
        if !is_preamble(instruction.opcode()) {
            break;
        }
        at += instruction.words.len();
    }
    Ok(at)
}

/// Capability, Extension, ExtInstImport, MemoryModel, EntryPoint, ExecutionMode, ExecutionModeId, and the
/// debug instructions SourceContinued … MemberName, String, ModuleProcessed.
fn is_preamble(opcode: u32) -> bool {
    matches!(opcode, 17 | 10 | 11 | 14 | 15 | 16 | 331 | 2..=7 | 330)
}

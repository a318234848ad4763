//! Removes the zeros that naga stores into local arrays.
//!
//! naga gives every local variable without an initialiser an `OpConstantNull`. For a traversal stack that is a loop of
//! stores at each call: without it traversal is 1.3 to 1.4 times faster on Mesa 22 and compiles in half the time. GLSL
//! leaves such an array undefined anyway; an array with its own initialiser keeps it.

use std::collections::HashMap;

use super::error::KernelError;
use super::spirv::{HEADER, Instruction};

const OP_TYPE_ARRAY: u32 = 28;
const OP_TYPE_POINTER: u32 = 32;
const OP_CONSTANT_NULL: u32 = 46;
const OP_VARIABLE: u32 = 59;
const STORAGE_FUNCTION: u32 = 7;

/// The module with `OpVariable pointer result Function null` cut to four words where the pointee is an array.
pub(super) fn strip_null_arrays(module: &[u32]) -> Result<Vec<u32>, KernelError> {
    let mut out = module.get(..HEADER).unwrap_or_default().to_vec();
    let mut arrays = Vec::new();
    let mut nulls = Vec::new();
    let mut pointees = HashMap::new();
    for instruction in Instruction::walk(module) {
        let instruction = instruction?;
        match instruction.opcode() {
            OP_TYPE_ARRAY => arrays.push(instruction.operand(0)),
            OP_TYPE_POINTER => {
                pointees.insert(instruction.operand(0), instruction.operand(2));
            }
            OP_CONSTANT_NULL => nulls.push(instruction.operand(1)),
            OP_VARIABLE => {
                let is_array = pointees
                    .get(&instruction.operand(0))
                    .is_some_and(|t| arrays.contains(t));
                let is_null =
                    instruction.words.len() == 5 && nulls.contains(&instruction.operand(3));
                if instruction.operand(2) == STORAGE_FUNCTION && is_array && is_null {
                    out.push(4 << 16 | OP_VARIABLE);
                    out.extend(&instruction.words[1..4]);
                    continue;
                }
            }
            _ => {}
        }
        out.extend(instruction.words);
    }
    Ok(out)
}

//! Removes local variables that are only another name of a value.
//!
//! naga copies every parameter of a function into a variable of its own, and keeps each `float x = …;` in one. Once a
//! driver has inlined all functions, those are thousands of variables: Mesa 22's lavapipe spent 70 % of its pipeline
//! creation time on them. A variable with one store that precedes every load needs no memory.

use std::collections::HashMap;

use super::error::KernelError;
use super::spirv::{HEADER, Instruction};

const OP_FUNCTION: u32 = 54;
const OP_FUNCTION_END: u32 = 56;
const OP_VARIABLE: u32 = 59;
const OP_LOAD: u32 = 61;
const OP_STORE: u32 = 62;
const OP_COPY_OBJECT: u32 = 83;
const OP_LABEL: u32 = 248;
const OP_BRANCH: u32 = 249;
const STORAGE_FUNCTION: u32 = 7;

/// The state of a variable during the analysis, and its fate at the end.
#[derive(Clone, Copy)]
enum Variable {
    /// Neither stored nor loaded yet.
    Unused,
    /// Stored once, where every call passes, and only loaded from there on.
    StoredOnce {
        value: u32,
    },
    Kept,
}

/// The module without such variables and their stores. Their loads become copies of the value, which leaves all names
/// as they are and costs a driver nothing.
pub(super) fn forward(module: &[u32]) -> Result<Vec<u32>, KernelError> {
    let mut out = module.get(..HEADER).unwrap_or_default().to_vec();
    let mut function = Vec::new();
    for instruction in Instruction::walk(module) {
        let instruction = instruction?;
        if function.is_empty() && instruction.opcode() != OP_FUNCTION {
            out.extend(instruction.words);
            continue;
        }
        function.push(instruction);
        if instruction.opcode() == OP_FUNCTION_END {
            rewrite(&function, &mut out);
            function.clear();
        }
    }
    Ok(out)
}

fn rewrite(function: &[Instruction], out: &mut Vec<u32>) {
    let variables = variables(function);
    for instruction in function {
        // Where the instruction names its variable.
        let place = match instruction.opcode() {
            OP_VARIABLE => 1,
            OP_STORE => 0,
            OP_LOAD => 2,
            _ => {
                out.extend(instruction.words);
                continue;
            }
        };
        match variables.get(&instruction.operand(place)) {
            Some(Variable::StoredOnce { value }) if instruction.opcode() == OP_LOAD => {
                out.push(4 << 16 | OP_COPY_OBJECT);
                out.extend([instruction.operand(0), instruction.operand(1), *value]);
            }
            Some(Variable::StoredOnce { .. }) => {}
            _ => out.extend(instruction.words),
        }
    }
}

/// The function's variables. Any instruction except a plain load or store keeps all variables whose numbers it
/// contains: such a number may be another operand's, but then only one removal is missed.
fn variables(function: &[Instruction]) -> HashMap<u32, Variable> {
    let opening = opening(function);
    let mut variables = HashMap::new();
    for (i, instruction) in function.iter().enumerate() {
        match (instruction.opcode(), instruction.words) {
            (OP_VARIABLE, [_, _, id, STORAGE_FUNCTION, ..]) => {
                variables.insert(*id, Variable::Unused);
            }
            (OP_STORE, &[_, pointer, value]) => {
                if let Some(variable) = variables.get_mut(&pointer) {
                    *variable = match variable {
                        Variable::Unused if i < opening => Variable::StoredOnce { value },
                        _ => Variable::Kept,
                    };
                }
                keep(&mut variables, &[value]);
            }
            // Before its store a variable has its initial value.
            (OP_LOAD, &[_, _, _, pointer]) => {
                if let Some(variable @ Variable::Unused) = variables.get_mut(&pointer) {
                    *variable = Variable::Kept;
                }
            }
            (_, words) => keep(&mut variables, &words[1..]),
        }
    }
    variables
}

fn keep(variables: &mut HashMap<u32, Variable>, ids: &[u32]) {
    for id in ids {
        if let Some(variable) = variables.get_mut(id) {
            *variable = Variable::Kept;
        }
    }
}

/// Number of instructions before the first branch. They dominate all that follow them: blocks come after those that
/// dominate them (SPIR-V 1.3, section 2.16.1), so a value stored here reaches every later load.
fn opening(function: &[Instruction]) -> usize {
    let parts = |pair: &[Instruction]| match pair[0].opcode() {
        OP_BRANCH => pair[1].opcode() != OP_LABEL || pair[0].operand(0) != pair[1].operand(0),
        // OpBranchConditional, OpSwitch, OpKill, OpReturn, OpReturnValue, OpUnreachable.
        opcode => matches!(opcode, 250..=255),
    };
    function.windows(2).position(parts).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn op(opcode: u32, operands: &[u32]) -> Vec<u32> {
        let mut words = vec![(operands.len() as u32 + 1) << 16 | opcode];
        words.extend(operands);
        words
    }

    /// A function of the value %20 with a variable %10, two blocks %30 and %31, and `body`.
    fn function(body: &[Vec<u32>]) -> Vec<u32> {
        let open = [op(54, &[1, 9, 0, 2]), op(55, &[3, 20]), op(OP_LABEL, &[30])];
        let variable = [op(OP_VARIABLE, &[4, 10, STORAGE_FUNCTION, 5])];
        let branch = [op(OP_BRANCH, &[31]), op(OP_LABEL, &[31])];
        let close = [op(OP_FUNCTION_END, &[])];
        let all = [&open[..], &variable, &branch, body, &close].concat();
        [vec![0; HEADER], all.concat()].concat()
    }

    fn opcodes(body: &[Vec<u32>]) -> Vec<u32> {
        let module = forward(&function(body)).expect("whole instructions");
        let all = Instruction::walk(&module).map(|i| i.expect("whole").opcode());
        all.filter(|o| [OP_VARIABLE, OP_LOAD, OP_STORE, OP_COPY_OBJECT].contains(o))
            .collect()
    }

    fn load(id: u32) -> Vec<u32> {
        op(OP_LOAD, &[3, id, 10])
    }

    fn store() -> Vec<u32> {
        op(OP_STORE, &[10, 20])
    }

    #[test]
    fn a_copied_parameter_is_the_parameter() {
        let body = [
            store(),
            load(40),
            op(250, &[6, 32, 33]),
            op(OP_LABEL, &[32]),
            load(41),
        ];
        assert_eq!(opcodes(&body), [OP_COPY_OBJECT; 2]);
        let module = forward(&function(&body)).expect("whole instructions");
        let copies = [
            op(OP_COPY_OBJECT, &[3, 40, 20]),
            op(OP_COPY_OBJECT, &[3, 41, 20]),
        ];
        for copy in copies {
            assert!(module.windows(4).any(|words| words == copy));
        }
    }

    #[test]
    fn variables_that_change_or_are_read_before_stay() {
        let part = [op(250, &[6, 32, 33]), op(OP_LABEL, &[32])].concat();
        let pointed_at = op(65, &[7, 42, 10, 21]);
        let loop_header = [op(OP_BRANCH, &[34]), op(OP_LABEL, &[35])].concat();
        for (what, body) in [
            ("two stores", vec![store(), load(40), store()]),
            ("read before", vec![load(40), store()]),
            ("on one of two ways", vec![part, store(), load(40)]),
            (
                "after a jump elsewhere",
                vec![loop_header, store(), load(40)],
            ),
            ("pointed at", vec![store(), load(40), pointed_at]),
            (
                "handed to a function",
                vec![store(), load(40), op(57, &[3, 43, 44, 10])],
            ),
            (
                "stored itself",
                vec![store(), load(40), op(OP_STORE, &[45, 10])],
            ),
        ] {
            let copies = opcodes(&body).contains(&OP_COPY_OBJECT);
            assert!(!copies && opcodes(&body).contains(&OP_VARIABLE), "{what}");
            assert_eq!(
                forward(&function(&body)).expect("whole"),
                function(&body),
                "{what}"
            );
        }
    }
}

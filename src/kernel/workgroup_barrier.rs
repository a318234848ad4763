//! The barrier that naga (30.0.1) makes of GLSL's `barrier()` waits for the subgroup alone: its front end requests
//! every kind of barrier at once, and its back end writes the narrowest of them. lavapipe waits for the workgroup
//! anyway, SwiftShader does not.

use naga::{Barrier, Block, Module, Statement};

/// Widens every barrier of a kernel to its workgroup, for shared memory and for buffers.
pub(super) fn widen(module: &mut Module) {
    for (_, function) in module.functions.iter_mut() {
        widen_in(&mut function.body);
    }
    for entry in &mut module.entry_points {
        widen_in(&mut entry.function.body);
    }
}

fn widen_in(block: &mut Block) {
    for statement in block.iter_mut() {
        match statement {
            Statement::ControlBarrier(kinds) => *kinds = Barrier::WORK_GROUP | Barrier::STORAGE,
            Statement::Block(inner) => widen_in(inner),
            Statement::If { accept, reject, .. } => [accept, reject].into_iter().for_each(widen_in),
            Statement::Loop {
                body, continuing, ..
            } => {
                [body, continuing].into_iter().for_each(widen_in);
            }
            Statement::Switch { cases, .. } => {
                cases.iter_mut().for_each(|case| widen_in(&mut case.body));
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::compile::{module_edited, words};
    use crate::kernel::{Composer, Instruction, file};

    const OP_CONSTANT: u32 = 43;
    const OP_CONTROL_BARRIER: u32 = 224;
    const SCOPE_WORKGROUP: u32 = 2;

    #[test]
    fn every_barrier_waits_for_the_workgroup() {
        let name = "doctor/barrier.comp";
        let kernel = Composer::new().compose(&[name]).expect("composed");
        let (module, info) = module_edited(&kernel, widen).expect("a module");
        let words = words(&module, &info).expect("SPIR-V");
        let all: Vec<Instruction> = Instruction::walk(&words).flatten().collect();
        let of = |opcode| all.iter().filter(move |i| i.opcode() == opcode);
        let value = |id| {
            of(OP_CONSTANT)
                .find(|c| c.operand(1) == id)
                .map(|c| c.operand(2))
        };
        let scopes: Vec<_> = of(OP_CONTROL_BARRIER)
            .map(|b| value(b.operand(0)))
            .collect();
        let written = file(name).map_or(0, |text| text.matches("barrier();").count());
        assert_eq!(scopes, vec![Some(SCOPE_WORKGROUP); written]);
        assert!(written > 1);
    }
}

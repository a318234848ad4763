//! SPIR-V words, and a walk over their instructions.

use super::error::KernelError;

/// A compiled compute kernel; its entry point is `main`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spirv {
    pub words: Vec<u32>,
    /// The names of its GLSL functions, in order of definition; an overloaded name appears once an overload.
    pub functions: Vec<String>,
    pub workgroup_size: [u32; 3],
}

impl Spirv {
    pub(super) fn new(words: Vec<u32>, functions: Vec<String>, workgroup_size: [u32; 3]) -> Self {
        Self {
            words,
            functions,
            workgroup_size,
        }
    }

    /// As in a `.spv` file.
    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.words)
    }

    /// All instructions, in order.
    pub fn instructions(&self) -> impl Iterator<Item = Instruction<'_>> {
        Instruction::walk(&self.words).filter_map(Result::ok)
    }
}

/// Number of words before the first instruction (SPIR-V 1.3, section 2.3).
pub(super) const HEADER: usize = 5;

/// One instruction: the first word contains length and opcode, the others are operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction<'a> {
    pub words: &'a [u32],
}

impl<'a> Instruction<'a> {
    pub fn opcode(self) -> u32 {
        self.words[0] & 0xffff
    }

    /// Operand `i`, result type and result included; 0 if it has none.
    pub fn operand(self, i: usize) -> u32 {
        self.words.get(i + 1).copied().unwrap_or(0)
    }

    /// Walks the instructions of a whole module; ends with an error if an instruction overruns it.
    pub(super) fn walk(module: &'a [u32]) -> impl Iterator<Item = Result<Self, KernelError>> {
        let mut rest = module.get(HEADER..).unwrap_or_default();
        std::iter::from_fn(move || {
            let first = *rest.first()?;
            let length = (first >> 16) as usize;
            if length == 0 || length > rest.len() {
                rest = &[];
                return Some(Err(KernelError::Spirv(format!(
                    "an instruction of {length} words overruns the module"
                ))));
            }
            let (words, after) = rest.split_at(length);
            rest = after;
            Some(Ok(Self { words }))
        })
    }
}

//! GLSL files → one composed text → SPIR-V; the only module that names naga.
//!
//! [`Composer`] picks the files that a kernel needs, [`compile`] turns them into [`Spirv`].

mod audit;
mod compile;
mod compose;
mod composed;
mod error;
mod no_contraction;
mod reflect;
mod sources;
mod spirv;
mod uninitialised;

pub use compile::compile;
pub use compose::{Composer, Slot};
pub use composed::{Composed, Place};
pub use error::{Culprit, KernelError};
pub use reflect::{Member, StructLayout, struct_layouts};
pub use sources::{file, files};
pub use spirv::{Instruction, Spirv};

//! GLSL files → one composed text → SPIR-V; the only module that names naga.
//!
//! [`Composer`] picks the files that a kernel needs, [`compile`] turns them into [`Spirv`].
//!
//! naga's GLSL (30.0.1) does not accept these, or treats them differently from GLSL:
//! - a buffer block with an instance name that has an unsized array *and* other members: reading one of those fails
//!   ("Loading of … can't be done"); give each block one member, or no instance name;
//! - a block's instance and its member of one name;
//! - `out` and `inout` of a component or a struct's member (a panic), `const in` and unnamed parameters;
//! - `&&` and `||` evaluate both sides; `x != x` is false for NaN, use `isnan`;
//! - `uint(x)` of a float clamps first: the same for 0 ≤ x < 2³² − 2⁸, the driver's choice for NaN;
//! - `float a, b; uint x[2], y;` declares `y` as an array too: one declaration a line;
//! - `barrier()` waits for the subgroup alone (`workgroup_barrier`); no kernel that renders has one;
//! - `#include`, `#line`, atomics, subgroup operations, 64-bit integers, `precise`, struct `==`, stacked `case` labels.

mod audit;
mod compile;
mod compose;
mod composed;
mod constants;
mod error;
mod no_contraction;
mod reflect;
pub mod scene;
mod single_store;
mod sources;
mod spirv;
pub mod unaudited;
mod uninitialised;
mod workgroup_barrier;

pub use compile::compile;
pub use compose::{Composer, OwnFile, Slot};
pub use composed::{Composed, Place};
pub use error::{Culprit, KernelError};
pub use reflect::{Member, StructLayout, struct_layouts};
pub use sources::{file, files};
pub use spirv::{Instruction, Spirv};

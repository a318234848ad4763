//! `scripts/`, as a person uses them.
#![cfg(unix)]

mod gpu;
pub mod program;
mod test;

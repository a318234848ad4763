//! `scripts/`, by what a person has of them.
#![cfg(unix)]

mod gpu;
pub mod program;
mod test;

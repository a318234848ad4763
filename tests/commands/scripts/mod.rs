//! `scripts/`, by what a person has of them.
#![cfg(unix)]

mod gpu;
mod program;
mod test;

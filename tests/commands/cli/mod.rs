//! The program itself: help, refusals, exit codes, and that a refusal leaves no file.

mod check;
mod classes;
mod compare;
mod converge;
mod converge_denoise;
mod converge_refusals;
mod denoise;
mod doctor;
mod ends;
#[cfg(target_os = "linux")]
mod environment;
mod explain;
mod export;
#[cfg(target_os = "linux")]
mod full;
mod help;
mod init;
mod integrator;
mod interrupt;
mod lamps;
mod layers;
mod live;
mod memory;
mod models;
#[cfg(target_os = "linux")]
mod outputs;
#[cfg(target_os = "linux")]
mod overwriting;
mod paired;
mod parts;
pub mod program;
mod refusals;
mod rendering;
mod resume;
mod standard_errors;
mod streams;
mod suite;
#[cfg(target_os = "linux")]
mod unwritable;
mod writers;

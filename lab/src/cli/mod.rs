//! The parts that command lines share: flags, sources, destinations, progress, and exit codes. Nothing else prints.

pub mod beside;
pub mod caller;
pub mod command;
pub mod console;
pub mod denoise;
pub mod destination;
pub mod exit;
pub mod failure;
pub mod identity;
pub mod inputs;
pub mod integrator;
pub mod interrupt;
pub mod job;
pub mod listing;
pub mod memory;
pub mod numbers;
pub mod progress;
pub mod settings;
pub mod source;
pub mod stderr;
pub mod streams;
pub mod values;
pub mod view;
pub mod writable;

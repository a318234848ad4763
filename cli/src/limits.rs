//! Limits of a process: memory, files, threads.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use rayon::ThreadPoolBuilder;
use signal_hook::consts::SIGABRT;
use signal_hook::flag::register_conditional_shutdown;

use vkpt_lab::cli::exit::{Failure, MEMORY};

/// Maps running out of memory to an exit code, and file limits to an error; fails if no threads can be created.
pub fn meet_limits() -> Result<(), Failure> {
    // If an allocation fails, Rust prints its size and aborts; a failing driver aborts, too. If no handler can be installed,
    // the signal ends the process.
    let always = Arc::new(AtomicBool::new(true));
    let _ = register_conditional_shutdown(SIGABRT, MEMORY.into(), always);
    fail_beyond_the_largest_file();
    let threads = ThreadPoolBuilder::new().build_global();
    threads.map_err(|error| Failure::Memory(format!("cannot create threads: {error}")))
}

/// Without a handler, a write beyond `ulimit -f` ends the process.
#[cfg(unix)]
fn fail_beyond_the_largest_file() {
    let seen = Arc::new(AtomicBool::new(false));
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, seen);
}

#[cfg(not(unix))]
fn fail_beyond_the_largest_file() {}

//! What a process may not have: memory, files, threads.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use rayon::ThreadPoolBuilder;
use signal_hook::consts::SIGABRT;
use signal_hook::flag::register_conditional_shutdown;

use vkpt_lab::cli::exit::{Failure, MEMORY};

/// Makes the end of memory an exit code, and that of files an error; fails where no threads can be made.
pub fn meet_limits() -> Result<(), Failure> {
    // Where an allocation fails, Rust says its size and aborts; so does a driver that gives up. Where no handler can be had,
    // the process ends by the signal.
    let always = Arc::new(AtomicBool::new(true));
    let _ = register_conditional_shutdown(SIGABRT, MEMORY.into(), always);
    fail_beyond_the_largest_file();
    let threads = ThreadPoolBuilder::new().build_global();
    threads.map_err(|error| Failure::Memory(format!("threads cannot be made: {error}")))
}

/// Without a handler, a write beyond `ulimit -f` ends the process.
#[cfg(unix)]
fn fail_beyond_the_largest_file() {
    let seen = Arc::new(AtomicBool::new(false));
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, seen);
}

#[cfg(not(unix))]
fn fail_beyond_the_largest_file() {}

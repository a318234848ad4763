//! Signals that end the program: after the first it finishes early and writes its results, the second ends it at once.

use std::ffi::c_int;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock};

use signal_hook::consts::SIGINT;
use signal_hook::flag;

use super::caller::caller;

/// Ctrl-c; the signal of batch systems before they kill; a closed terminal.
#[cfg(unix)]
const ENDING: [c_int; 3] = [
    SIGINT,
    signal_hook::consts::SIGTERM,
    signal_hook::consts::SIGHUP,
];
#[cfg(not(unix))]
const ENDING: [c_int; 1] = [SIGINT];

/// The signal that came last, 0 before any.
static LAST: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// Set by the first of the signals from now on; for a calling program, which handles signals itself, its flag.
pub fn stop_flag() -> Arc<AtomicBool> {
    if let Some(by) = caller() {
        return by.stop;
    }
    let stop = Arc::new(AtomicBool::new(false));
    for signal in ENDING.into_iter().filter(|signal| !is_ignored(*signal)) {
        // Handlers run in this order: the first signal finds the flag unset, sets it, and the second quits.
        // If no handler can be installed, the signal keeps its usual meaning.
        let _ = flag::register_conditional_shutdown(signal, code(signal), stop.clone())
            .and_then(|_| flag::register_usize(signal, LAST.clone(), signal as usize))
            .and_then(|_| flag::register(signal, stop.clone()));
    }
    stop
}

/// The exit code after an interruption, as in shells: 128 plus the signal.
pub fn exit_code() -> u8 {
    let signal = match LAST.load(Ordering::Relaxed) {
        0 => SIGINT,
        signal => signal as c_int,
    };
    code(signal) as u8
}

fn code(signal: c_int) -> c_int {
    128 + signal
}

/// Whether the program was started with the signal ignored, as `nohup` does, and shells do for background jobs:
/// it stays ignored, where Linux shows it.
fn is_ignored(signal: c_int) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

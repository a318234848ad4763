//! Ctrl-c: the first asks the rendering to finish early, the second quits at once.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::SIGINT;
use signal_hook::flag;

/// Set by the first ctrl-c from now on.
pub fn stop_flag() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    // Handlers run in this order: the first ctrl-c finds the flag unset, sets it, and the second quits.
    // Where no handler can be had, ctrl-c keeps its usual meaning.
    let _ = flag::register_conditional_shutdown(SIGINT, 130, stop.clone())
        .and_then(|_| flag::register(SIGINT, stop.clone()));
    stop
}

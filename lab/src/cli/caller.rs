//! A program that runs a command in its own process, as the Python module does, in place of a terminal.
//!
//! It receives warnings and progress, and owns the flag that ends the work early. The thread identifies the caller: a
//! command reports on the thread that called it.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Receives the messages of a command. It has no influence on the command's results.
pub trait Caller {
    /// A warning, as printed on stderr after `warning: `.
    fn warn(&mut self, message: &str);

    /// The fraction of the work that is done, in [0, 1]; `words` makes the text next to the progress bar.
    fn progress(&mut self, fraction: f64, words: &dyn Fn() -> String);
}

/// The caller, and the flag that ends the work early.
#[derive(Clone)]
pub struct Called {
    pub caller: Rc<RefCell<dyn Caller>>,
    pub stop: Arc<AtomicBool>,
}

thread_local! {
    static CALLED: RefCell<Option<Called>> = const { RefCell::new(None) };
}

/// Does the work of a command for a caller.
pub fn called<T>(by: Called, work: impl FnOnce() -> T) -> T {
    let _earlier = Restore(CALLED.replace(Some(by)));
    work()
}

/// Restores the previous caller: a caller may call a command while it receives messages of another.
struct Restore(Option<Called>);

impl Drop for Restore {
    fn drop(&mut self) {
        CALLED.set(self.0.take());
    }
}

/// The caller on this thread; `None` for the command line.
pub fn caller() -> Option<Called> {
    CALLED.with_borrow(Clone::clone)
}

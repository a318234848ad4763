//! A program that runs a command in its own process, as the Python module does, where otherwise a terminal is.
//!
//! It hears warnings, is shown progress, and has the flag that ends the work early. Who calls is known by the thread: a
//! command speaks on the thread that called it.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Hears what a command says. Nothing that it does has an influence on what the command makes.
pub trait Caller {
    /// A warning, as stderr has it after `warning: `.
    fn warn(&mut self, message: &str);

    /// The part of all work that is done, in [0, 1]; `words` makes what stands beside the progress bar.
    fn progress(&mut self, fraction: f64, words: &dyn Fn() -> String);
}

/// Who called, and what ends the work early.
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

/// Puts back who called before: a caller may call a command while it hears another.
struct Restore(Option<Called>);

impl Drop for Restore {
    fn drop(&mut self) {
        CALLED.set(self.0.take());
    }
}

/// Who called on this thread; `None` where the command line did.
pub fn caller() -> Option<Called> {
    CALLED.with_borrow(Clone::clone)
}

//! Python as the caller of a command: warnings, progress, ctrl-c.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use pyo3::exceptions::{PyKeyboardInterrupt, PyUserWarning};
use pyo3::prelude::*;
use vkpt_lab::cli::caller::{Called, Caller, called};

/// Time between two calls into Python: taking the GIL costs time.
const PAUSE: Duration = Duration::from_millis(50);

/// The warnings and the progress of a command, for Python.
struct Ears {
    warnings: Vec<String>,
    progress: Option<Py<PyAny>>,
    looked: Instant,
    stop: Arc<AtomicBool>,
    /// The exception that `progress` raised.
    raised: Option<PyErr>,
}

impl Caller for Ears {
    fn warn(&mut self, message: &str) {
        self.warnings.push(message.to_owned());
    }

    fn progress(&mut self, fraction: f64, words: &dyn Fn() -> String) {
        if self.looked.elapsed() < PAUSE {
            return;
        }
        self.looked = Instant::now();
        Python::attach(|py| {
            // Ctrl-c ends the work with the samples done.
            if py.check_signals().is_err() {
                self.stop.store(true, Ordering::Relaxed);
            }
            let progress = self.progress.as_ref().filter(|_| self.raised.is_none());
            let shown = progress.map(|show| show.call1(py, (fraction, words())));
            if let Some(Err(error)) = shown {
                self.stop.store(true, Ordering::Relaxed);
                // Ctrl-c may also arrive while `progress` runs.
                let is_ctrl_c = error.is_instance_of::<PyKeyboardInterrupt>(py);
                self.raised = (!is_ctrl_c).then_some(error);
            }
        });
    }
}

/// Does the work of a command without the GIL; `progress` is called with the fraction done, in [0, 1], and a text. Warnings
/// become Python's.
pub fn call<T: Send>(
    py: Python,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let stop = Arc::new(AtomicBool::new(false));
    let (made, warnings, raised) = py.detach(|| {
        let ears = Rc::new(RefCell::new(Ears {
            warnings: Vec::new(),
            progress,
            looked: Instant::now(),
            stop: stop.clone(),
            raised: None,
        }));
        let caller = ears.clone();
        let made = called(Called { caller, stop }, work);
        let mut ears = ears.borrow_mut();
        (made, std::mem::take(&mut ears.warnings), ears.raised.take())
    });
    if let Some(error) = raised {
        return Err(error);
    }
    warn(py, warnings)?;
    Ok(made)
}

/// Warns at the call of the package's function, one frame above this one.
pub fn warn(py: Python, warnings: Vec<String>) -> PyResult<()> {
    let category = py.get_type::<PyUserWarning>();
    for warning in warnings {
        let message = std::ffi::CString::new(warning)?;
        PyErr::warn(py, &category, &message, 2)?;
    }
    Ok(())
}

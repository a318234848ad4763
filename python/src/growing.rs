//! A rendering in a separate thread that delivers pictures as it runs.

use std::cell::RefCell;
use std::ffi::OsString;
use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use vkpt_cli::{RenderArguments, Rendered, rendered};
use vkpt_lab::cli::caller::{Called, Caller, called};
use vkpt_lab::cli::exit::Failure;

use crate::caller::warn;
use crate::failure::raise;
use crate::picture::Picture;
use crate::render::arguments;
use crate::scene::Scene;

/// Time between two checks for ctrl-c.
const PAUSE: Duration = Duration::from_millis(50);

/// A message from the thread.
enum News {
    Warning(String),
    Picture(Box<Rendered>),
    /// The last picture; `None` if the rendering was stopped before the first sample.
    Last(Box<Result<Option<Rendered>, Failure>>),
}

/// An iterator over the pictures of a rendering as they grow; the last is the finished one.
#[pyclass(frozen, module = "vkpt")]
pub struct Growing {
    news: Mutex<Option<Receiver<News>>>,
    stop: Arc<AtomicBool>,
    /// Whether a picture was requested: none is made otherwise.
    waits: Arc<AtomicBool>,
}

#[pymethods]
impl Growing {
    /// `words` are flags of `vkpt SCENE`; pictures come `pause` seconds after one another or later.
    #[new]
    fn new(py: Python, scene: Scene, words: Vec<OsString>, pause: f64) -> PyResult<Self> {
        let arguments = arguments(scene, words).map_err(|failure| raise(py, failure))?;
        let pause = Duration::try_from_secs_f64(pause)
            .map_err(|error| raise(py, Failure::Usage(format!("pause={pause:?}: {error}"))))?;
        let (to, news) = channel();
        let growing = Self {
            news: Mutex::new(Some(news)),
            stop: Arc::default(),
            waits: Arc::default(),
        };
        let (stop, waits) = (growing.stop.clone(), growing.waits.clone());
        let thread = std::thread::Builder::new().name("vkpt".to_owned());
        thread.spawn(move || grow(&arguments, pause, to, stop, &waits))?;
        Ok(growing)
    }

    fn __iter__(this: Py<Self>) -> Py<Self> {
        this
    }

    fn __next__(&self, py: Python) -> PyResult<Option<Picture>> {
        // No lock is held while this waits, because another thread may have the GIL.
        let Some(mut news) = self.news().take() else {
            return Ok(None);
        };
        self.waits.store(true, Ordering::Relaxed);
        loop {
            let received;
            (news, received) = py.detach(move || {
                let received = news.recv_timeout(PAUSE);
                (news, received)
            });
            match received {
                Ok(News::Warning(warning)) => warn(py, vec![warning])?,
                Ok(News::Picture(rendered)) => {
                    *self.news() = Some(news);
                    return Picture::growing(py, *rendered).map(Some);
                }
                Ok(News::Last(last)) => {
                    return match last.map_err(|failure| raise(py, failure))? {
                        Some(rendered) => Picture::new(py, rendered).map(Some),
                        None => Err(PyKeyboardInterrupt::new_err(())),
                    };
                }
                // Ctrl-c ends the rendering with the samples done.
                Err(RecvTimeoutError::Timeout) if py.check_signals().is_err() => {
                    self.stop.store(true, Ordering::Relaxed);
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return Ok(None),
            }
        }
    }
}

impl Growing {
    fn news(&self) -> MutexGuard<'_, Option<Receiver<News>>> {
        self.news.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// Sends warnings to the thread that waits.
struct Ears(Sender<News>);

impl Caller for Ears {
    fn warn(&mut self, message: &str) {
        // If the receiver is gone, the warning is dropped.
        let _ = self.0.send(News::Warning(message.to_owned()));
    }

    fn progress(&mut self, _: f64, _: &dyn Fn() -> String) {}
}

/// Renders, and sends a picture when one was requested and `pause` has passed.
fn grow(
    arguments: &RenderArguments,
    pause: Duration,
    to: Sender<News>,
    stop: Arc<AtomicBool>,
    waits: &AtomicBool,
) {
    let mut last = Instant::now();
    let mut growing = |so_far: &dyn Fn() -> Rendered| {
        if last.elapsed() >= pause && waits.swap(false, Ordering::Relaxed) {
            let picture = so_far();
            // The last one is sent with its layers instead.
            if picture.record.job.ended == "interrupted" {
                let _ = to.send(News::Picture(Box::new(picture)));
            }
            last = Instant::now();
        }
    };
    let caller = Rc::new(RefCell::new(Ears(to.clone())));
    let made = called(Called { caller, stop }, || {
        rendered(arguments, &mut growing)
    });
    let _ = to.send(News::Last(Box::new(made)));
}

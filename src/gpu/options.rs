//! How a device is opened.

use std::path::PathBuf;
use std::time::Duration;

use crate::cache;

/// How a device is opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Run under the Khronos validation layer, including synchronisation; an error if it is not installed.
    pub validation: bool,
    /// Put all buffers in memory that the host does not see, as on a discrete GPU.
    pub always_stage: bool,
    /// How long to wait for one piece of work.
    pub patience: Duration,
    /// The folder that keeps compiled kernels from one process to the next; `None`: they are not kept.
    pub cache: Option<PathBuf>,
    /// Make the driver collect statistics of its compiler: [`Pipeline::statistics`](super::Pipeline::statistics).
    pub statistics: bool,
}

impl Options {
    /// Validation if the environment has `VKPT_VALIDATION=1`; the cache in the folder that `VKPT_CACHE`
    /// names, or in the user's.
    pub fn from_env() -> Self {
        let validation = std::env::var_os("VKPT_VALIDATION").is_some_and(|v| v == "1");
        Self {
            validation,
            cache: cache::from_env(),
            ..Self::default()
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            validation: false,
            always_stage: false,
            patience: Duration::from_secs(120),
            cache: None,
            statistics: false,
        }
    }
}

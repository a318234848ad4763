//! The pictures that a calling program compares, in files or in memory.

use std::path::PathBuf;

use vkpt::film::Film;

/// A picture to compare.
#[derive(Clone, Debug)]
pub enum Comparand {
    /// With the standard errors next to it, if present.
    File(PathBuf),
    Memory {
        /// Its name in messages.
        name: String,
        film: Film,
        /// Column and row of its first pixel, if it is a crop.
        origin: Option<[u32; 2]>,
        /// Standard errors, and their degrees of freedom.
        stderr: Option<(Film, f64)>,
    },
}

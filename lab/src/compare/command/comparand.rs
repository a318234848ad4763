//! What a program that calls compares: pictures in files, or in memory.

use std::path::PathBuf;

use vkpt::film::Film;

/// A picture to compare.
#[derive(Clone, Debug)]
pub enum Comparand {
    /// With its standard errors beside it, where they are there.
    File(PathBuf),
    Memory {
        /// What messages call it.
        name: String,
        film: Film,
        /// Column and row of its first pixel, if it is a crop.
        origin: Option<[u32; 2]>,
        /// Standard errors, and their degrees of freedom.
        stderr: Option<(Film, f64)>,
    },
}

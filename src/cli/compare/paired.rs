//! `vkpt compare --paired SCENE`: the same paths by three renderers.

use super::arguments::PairedArguments;
use crate::cli::arguments::usage;
use crate::cli::exit::{Ending, Failure};
use crate::cli::job::Ready;

/// Compares the Vulkan device, cpu-f32 and cpu-f64 path by path.
pub fn paired(arguments: &PairedArguments) -> Result<Ending, Failure> {
    let request = arguments
        .request()
        .ok_or_else(|| usage("a scene file is missing"))?;
    let ready = Ready::new(&request)?;
    ready.job(&request)?;
    Err(usage("compare --paired: comes with the next change"))
}

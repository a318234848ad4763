//! `vkpt devices`: what can render here, and what can't and why.

use super::exit::{Ending, Failure};

/// Prints a table on stdout.
pub fn devices() -> Result<Ending, Failure> {
    println!("cpu-f64, cpu-f32");
    Ok(Ending::Complete)
}

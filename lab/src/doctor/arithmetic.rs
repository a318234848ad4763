//! Arithmetic compared with the host's, bit by bit, in kernels compiled like those that render.

use super::arguments::{cancelling, wide};
use super::bench::{Bench, Caller, Subject};
use super::compare::{compare_floats, compare_moved, compare_words};
use super::operations::{AS_WRITTEN, FLOATS, WORDS};
use crate::doctor::report::Operation;
use vkpt::gpu::GpuError;

/// All operations; a dispatch each.
pub fn operations(bench: &Bench) -> Result<Vec<Operation>, GpuError> {
    let (wide, cancelling) = (wide(), cancelling());
    let mut all = Vec::new();
    for (operations, table) in [(&FLOATS[..], &wide), (&AS_WRITTEN[..], &cancelling)] {
        for o in operations {
            let results = bench.call(&Subject::float("", o.expression), table)?;
            all.push(compare_floats(o, table, &results));
        }
    }
    let moved = Caller::new(bench.device, &bench.file("doctor/move.comp")?, wide.len())?;
    all.push(compare_moved(&wide, &moved.call(&wide)?));
    for o in &WORDS {
        let results = bench.call(&Subject::word(o.expression), &wide)?;
        all.push(compare_words(o, &wide, &results));
    }
    Ok(all)
}

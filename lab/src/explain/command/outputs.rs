//! The files that an explanation leaves: the SPIR-V of each kernel.

use super::arguments::ExplainArguments;
use crate::cli::destination::{Destination, Written};
use crate::cli::exit::Failure;
use crate::cli::inputs::{Input, spare};
use crate::cli::writable::{self, Claims};
use vkpt::kernel::Spirv;

/// Where each of the kernels goes, known to be writable and claimed; nowhere if nobody asks.
pub fn check(
    arguments: &ExplainArguments,
    kernels: usize,
    inputs: &[Input],
) -> Result<(Vec<Destination>, Claims), Failure> {
    let to = arguments.spirv.iter();
    let files: Vec<_> = to
        .flat_map(|to| (0..kernels).map(|i| numbered(to, i)))
        .collect();
    // Where nothing can stand beside the first, all go there, one after the other.
    let mut distinct = files.clone();
    distinct.dedup();
    let claims = writable::check(&distinct)?;
    spare(inputs, &distinct)?;
    Ok((files, claims))
}

/// Writes them.
pub fn write(files: &[Destination], spirv: &[Spirv]) -> Vec<Written> {
    let all = files.iter().zip(spirv);
    all.map(|(to, spirv)| to.write(|out| out.write_all(spirv.bytes())))
        .collect()
}

/// Where kernel `i` goes: the first to FILE itself, the next to FILE-2.
fn numbered(to: &Destination, i: usize) -> Destination {
    match (to.neighbour(), i) {
        (None, _) | (_, 0) => to.clone(),
        (Some(path), i) => {
            let mut name = path.file_stem().unwrap_or_default().to_owned();
            name.push(format!("-{}", i + 1));
            if let Some(suffix) = path.extension() {
                name.push(".");
                name.push(suffix);
            }
            Destination::File(path.with_file_name(name))
        }
    }
}

//! The files that an explanation writes: the SPIR-V of each kernel.

use super::arguments::ExplainArguments;
use crate::cli::destination::{Destination, Written};
use crate::cli::exit::Failure;
use crate::cli::inputs::{Input, spare};
use crate::cli::writable::{self, Claims};
use vkpt::kernel::Spirv;

/// The destination of each kernel, checked to be writable and claimed; none if not requested.
pub fn check(
    arguments: &ExplainArguments,
    kernels: usize,
    inputs: &[Input],
) -> Result<(Vec<Destination>, Claims), Failure> {
    let to = arguments.spirv.iter();
    let files: Vec<_> = to
        .flat_map(|to| (0..kernels).map(|i| numbered(to, i)))
        .collect();
    // If no file can be written next to the first, all go there, one after the other.
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

/// The destination of kernel `i`: the first goes to FILE itself, the next to FILE-2.
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

//! Resuming from a part on disk.

use std::ops::Range;
use std::path::Path;

use vkpt::film::Keeps;
use vkpt::part::AnyPart;
use vkpt::render::Target;
use vkpt::state::{self, Header, Kept, differs};
use vkpt_lab::cli::exit::{Failure, note};

/// The part that `--resume` continues; `None` if it does not exist.
///
/// # Errors
/// If the part belongs to another rendering or contains other samples than requested: `samples` are the first index and the
/// one after the last. `keeps`: the data that it must have besides its sums.
pub fn resumed(
    path: &Path,
    own: &Header,
    samples: Range<u32>,
    target: &Target,
    keeps: Keeps,
) -> Result<Option<Kept>, Failure> {
    if !path.exists() {
        note(&format!(
            "{} does not exist: rendering from the first sample",
            path.display()
        ));
        return Ok(None);
    }
    let wrong = |why: String| {
        let path = path.display();
        Failure::Pictures(vec![format!("--resume cannot continue {path}: {why}")])
    };
    let kept = state::read(path).map_err(|error| wrong(error.to_string()))?;
    let range = kept.part.range();
    let why = match (differs(&kept.header, own), &kept.part) {
        (Some(difference), _) => Some(difference.between(["the file", "this command"])),
        (_, AnyPart::F64(_)) if *target != Target::CpuF64 => {
            Some("it was rendered by cpu-f64: add --device cpu-f64".to_owned())
        }
        (_, AnyPart::F32(_)) if *target == Target::CpuF64 => {
            Some("it was not rendered by cpu-f64: omit --device cpu-f64".to_owned())
        }
        _ if range.start != samples.start => Some(format!(
            "it starts at sample {}, not {}",
            range.start, samples.start
        )),
        _ if range.end > samples.end => Some(format!(
            "it already has {} samples per pixel, more than the {} requested",
            range.len(),
            samples.len()
        )),
        (_, part) if part.keeps() != keeps => Some(lacks(part.keeps(), keeps)),
        _ => None,
    };
    match why {
        Some(why) => Err(wrong(why)),
        None => Ok(Some(kept)),
    }
}

/// Advice if a part has `has` besides its sums, and `wanted` is requested.
fn lacks(has: Keeps, wanted: Keeps) -> String {
    match (has, wanted) {
        (Keeps::Quarters, _) => "it was rendered with --denoise: add that flag",
        (_, Keeps::Quarters) => "it lacks the data that --denoise needs: omit that flag",
        (Keeps::Moments, _) => "it was rendered with --aov stderr: add that flag",
        _ => "it lacks the data that --aov stderr needs: omit that flag",
    }
    .to_owned()
}

/// Notes that a part of the same rendering exists, which is about to be overwritten.
pub fn hint(path: &Path, own: &Header, samples: Range<u32>) {
    if let Ok((header, [begin, end], _)) = state::read_header(path)
        && differs(&header, own).is_none()
        && begin == samples.start
        && end <= samples.end
    {
        let count = end - begin;
        note(&format!(
            "{} contains {count} samples per pixel of this rendering: continue from them with --resume",
            path.display()
        ));
    }
}

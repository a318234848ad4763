//! Going on from a part on disk.

use std::ops::Range;
use std::path::Path;

use vkpt::film::Keeps;
use vkpt::part::AnyPart;
use vkpt::render::Target;
use vkpt::state::{self, Header, Kept, differs};
use vkpt_lab::cli::exit::{Failure, note};

/// The part to go on from, by `--resume`; `None` where there is none yet.
///
/// # Errors
/// Of a part of something else, or of other samples: `samples` are the first index and the one after the last that are asked
/// for. `keeps`: what it must have beside its sums.
pub fn resumed(
    path: &Path,
    own: &Header,
    samples: Range<u32>,
    target: &Target,
    keeps: Keeps,
) -> Result<Option<Kept>, Failure> {
    if !path.exists() {
        note(&format!(
            "there is no {}: the rendering begins anew",
            path.display()
        ));
        return Ok(None);
    }
    let wrong = |why: String| {
        let path = path.display();
        Failure::Pictures(vec![format!("--resume cannot go on from {path}: {why}")])
    };
    let kept = state::read(path).map_err(|error| wrong(error.to_string()))?;
    let range = kept.part.range();
    let why = match (differs(&kept.header, own), &kept.part) {
        (Some(difference), _) => Some(difference),
        (_, AnyPart::F64(_)) if *target != Target::CpuF64 => {
            Some("it is of cpu-f64: add --device cpu-f64".to_owned())
        }
        (_, AnyPart::F32(_)) if *target == Target::CpuF64 => {
            Some("it is not of cpu-f64: leave --device cpu-f64 out".to_owned())
        }
        _ if range.start != samples.start => Some(format!(
            "it begins at sample {}, not {}",
            range.start, samples.start
        )),
        _ if range.end > samples.end => Some(format!(
            "it has {} samples a pixel already, more than the {} asked for",
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

/// What to do where a part has `has` beside its sums, and `wanted` is asked for.
fn lacks(has: Keeps, wanted: Keeps) -> String {
    match (has, wanted) {
        (Keeps::Quarters, _) => "it was rendered with --denoise: add that",
        (_, Keeps::Quarters) => "--denoise needs what its samples have not left: leave that out",
        (Keeps::Moments, _) => "it was rendered with --aov stderr: add that",
        _ => "--aov stderr needs what its samples have not left: leave that out",
    }
    .to_owned()
}

/// Says that a part of the same rendering is there, which is about to be written over.
pub fn hint(path: &Path, own: &Header, samples: Range<u32>) {
    if let Ok((header, [begin, end], _)) = state::read_header(path)
        && differs(&header, own).is_none()
        && begin == samples.start
        && end <= samples.end
    {
        let count = end - begin;
        note(&format!(
            "{} has {count} samples a pixel of this rendering: --resume goes on from them",
            path.display()
        ));
    }
}

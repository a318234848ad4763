//! The parts in the order of their samples, and their errors.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::arguments::MergeArguments;
use vkpt::film::Keeps;
use vkpt::shell::quoted;
use vkpt::state::{self, Header, differs};
use vkpt_lab::cli::command;
use vkpt_lab::cli::exit::Failure;

/// A file and its header.
struct Named {
    path: PathBuf,
    header: Header,
    samples: Range<u32>,
}

/// Parts of one picture, each beginning where the one before ends.
pub struct InOrder {
    parts: Vec<Named>,
    /// Whether all have moments in addition to sums.
    pub keep_moments: bool,
}

impl InOrder {
    /// The header of the first part.
    pub fn first(&self) -> &Header {
        &self.parts[0].header
    }

    /// The headers of all parts, in order.
    pub fn headers(&self) -> impl Iterator<Item = &Header> {
        self.parts.iter().map(|part| &part.header)
    }

    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.parts.iter().map(|part| &*part.path)
    }

    /// Indices of all samples together.
    pub fn samples(&self) -> Range<u32> {
        let end = self.parts.iter().map(|part| part.samples.end).max();
        self.parts[0].samples.start..end.unwrap_or(0)
    }

    /// Whether the bits are those of one rendering.
    pub fn round_alike(&self) -> bool {
        let first = &self.first().rounding;
        self.headers().all(|header| header.rounding == *first)
    }

    /// How their devices round.
    pub fn rounding(&self) -> String {
        let mut all: Vec<&str> = self.headers().map(|h| &*h.rounding).collect();
        all.dedup();
        all.join(", then ")
    }
}

/// Reads the headers of the parts and puts them in order.
///
/// # Errors
/// Files that are not parts; if none, parts of another picture; if none, samples that are missing or duplicated.
pub fn in_order(arguments: &MergeArguments) -> Result<InOrder, Failure> {
    let (mut parts, mut wrong, mut keep_moments) = (Vec::new(), Vec::new(), true);
    for path in &arguments.parts {
        match state::read_header(path) {
            Ok((header, [begin, end], keeps)) => {
                keep_moments &= keeps == Keeps::Moments;
                parts.push(Named {
                    path: path.clone(),
                    header,
                    samples: begin..end,
                });
            }
            Err(error) => wrong.push(format!("{}: {error}", path.display())),
        }
    }
    none_wrong(wrong)?;
    none_wrong(foreign(&parts))?;
    parts.sort_by_key(|part| (part.samples.start, part.samples.end));
    none_wrong(misplaced(&parts))?;
    let parts = InOrder {
        parts,
        keep_moments,
    };
    let end = parts.samples().end;
    match arguments.spp.filter(|&spp| spp != end) {
        Some(spp) if end < spp => {
            let command = command::part(&parts.first().record.job, end..spp);
            let message = format!(
                "samples {end}..{spp} are missing at the end: render them with\n  {command}"
            );
            none_wrong(vec![message])?;
        }
        Some(spp) => none_wrong(vec![format!(
            "the parts have {end} samples per pixel, more than --spp {spp}: omit some parts, or --spp"
        )])?,
        None => {}
    }
    Ok(parts)
}

fn none_wrong(wrong: Vec<String>) -> Result<(), Failure> {
    match wrong.is_empty() {
        true => Ok(()),
        false => Err(Failure::Pictures(wrong)),
    }
}

/// Parts of another picture than the first.
fn foreign(parts: &[Named]) -> Vec<String> {
    let Some((first, others)) = parts.split_first() else {
        return Vec::new();
    };
    let difference = |part: &Named| {
        let names = [first, part].map(|part| part.path.display().to_string());
        let difference = differs(&first.header, &part.header)?;
        let [a, b] = names.each_ref().map(String::as_str);
        Some(format!(
            "{a} and {b} do not belong together: {}",
            difference.between([a, b])
        ))
    };
    others.iter().filter_map(difference).collect()
}

/// Samples that are missing between two parts, or are in both.
fn misplaced(parts: &[Named]) -> Vec<String> {
    let mut wrong = Vec::new();
    // The part that reaches furthest so far.
    let mut last = 0;
    for next in 1..parts.len() {
        let (a, b) = (&parts[last], &parts[next]);
        let (end, begin) = (a.samples.end, b.samples.start);
        let [left, right] = [a, b].map(|part| {
            let Range { start, end } = part.samples;
            format!("{} ({start}..{end})", part.path.display())
        });
        if begin < end {
            let both = begin..end.min(b.samples.end);
            wrong.push(match a.path == b.path {
                true => format!("{left} is given twice: omit one"),
                false => format!(
                    "{left} and {right} both contain samples {}..{}: omit one of them",
                    both.start, both.end
                ),
            });
        } else if begin > end {
            wrong.push(format!(
                "samples {end}..{begin} are missing between {left} and {right}: {}",
                mended(a, end..begin)
            ));
        }
        if b.samples.end > end {
            last = next;
        }
    }
    wrong
}

/// How to render the samples that should follow a part.
fn mended(part: &Named, missing: Range<u32>) -> String {
    let job = &part.header.record.job;
    let asked = part.samples.start.saturating_add(job.spp_asked);
    match part.samples.end < asked {
        true => format!(
            "the first ended early, continue it with\n  {} --resume -o {}",
            command::rendering(job, part.samples.start..asked),
            quoted(&part.path.to_string_lossy())
        ),
        false => format!("render them with\n  {}", command::part(job, missing)),
    }
}

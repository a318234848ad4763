//! The files that an experiment writes.

use std::io;

use super::arguments::ConvergeArguments;
use crate::cli::destination::{Destination, Written, json, whole};
use crate::cli::exit::warn;
use crate::converge::report::{Sheet, csv, page, svg};
use vkpt::report::human::bytes;

/// A page of more bytes than this is slow to open, and too large for most mail.
const LARGE: usize = 50_000_000;

/// The files that the command line requests.
pub fn files(arguments: &ConvergeArguments) -> impl Iterator<Item = &Destination> {
    let ConvergeArguments {
        json,
        csv,
        svg,
        html,
        ..
    } = arguments;
    [json, csv, svg, html].into_iter().flatten()
}

/// Writes them.
pub fn write(arguments: &ConvergeArguments, sheet: &Sheet) -> [Written; 4] {
    let record = sheet.record;
    [
        whole(&arguments.json, || json(record)),
        whole(&arguments.csv, || Ok(csv(record))),
        whole(&arguments.svg, || Ok(svg(record))),
        whole(&arguments.html, || html(sheet)),
    ]
}

/// Pictures are embedded at full size: scaling would hide the noise.
fn html(sheet: &Sheet) -> io::Result<String> {
    let text = page(sheet).map_err(io::Error::other)?;
    if text.len() > LARGE {
        let size = bytes(text.len() as u64);
        warn(&format!(
            "the page takes {size}: use --crop or --size for smaller pictures, or --spp for fewer"
        ));
    }
    Ok(text)
}

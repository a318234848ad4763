//! The files that an experiment leaves.

use std::io::{self, Write};
use std::path::Path;

use super::arguments::ConvergeArguments;
use crate::cli::exit::{Failure, warn};
use crate::image::file::{FileError, check_writable, write_whole};
use crate::report::convergence::{Sheet, csv, page, svg};
use crate::report::human::bytes;

/// Each known to be writable when the experiment starts.
pub struct Outputs<'a> {
    json: Option<&'a Path>,
    csv: Option<&'a Path>,
    svg: Option<&'a Path>,
    html: Option<&'a Path>,
}

/// A page of more bytes than this is slow to open, and too large for most mail.
const LARGE: usize = 50_000_000;

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a ConvergeArguments) -> Result<Self, Failure> {
        let ConvergeArguments {
            json,
            csv,
            svg,
            html,
            ..
        } = arguments;
        let all = [json, csv, svg, html].map(Option::as_deref);
        let checked = all.into_iter().flatten().map(check_writable);
        failed(checked.filter_map(Result::err).collect())?;
        let [json, csv, svg, html] = all;
        Ok(Self {
            json,
            csv,
            svg,
            html,
        })
    }

    /// Writes what was asked for.
    pub fn write(&self, sheet: &Sheet) -> Result<(), Failure> {
        let record = sheet.record;
        let json = || {
            let text = serde_json::to_string_pretty(record)?;
            Ok(text + "\n")
        };
        let written = [
            whole(self.json, json),
            whole(self.csv, || Ok(csv(record))),
            whole(self.svg, || svg(record).map_err(io::Error::other)),
            whole(self.html, || html(sheet)),
        ];
        failed(written.into_iter().filter_map(Result::err).collect())
    }
}

/// Pictures are embedded as they are, for a scaled one would hide what it is there to show.
fn html(sheet: &Sheet) -> io::Result<String> {
    let text = page(sheet).map_err(io::Error::other)?;
    if text.len() > LARGE {
        let size = bytes(text.len() as u64);
        warn(&format!(
            "the page takes {size}: --crop or --size make its pictures smaller, --spp their number"
        ));
    }
    Ok(text)
}

/// Writes a text, if it was asked for.
fn whole(path: Option<&Path>, text: impl FnOnce() -> io::Result<String>) -> Result<(), FileError> {
    let Some(path) = path else { return Ok(()) };
    write_whole(path, |out| out.write_all(text()?.as_bytes()))
}

fn failed(errors: Vec<FileError>) -> Result<(), Failure> {
    match errors.is_empty() {
        true => Ok(()),
        false => Err(Failure::Files(errors)),
    }
}

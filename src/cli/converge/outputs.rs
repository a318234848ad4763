//! The files that an experiment leaves.

use std::io;
use std::path::Path;

use super::arguments::ConvergeArguments;
use crate::cli::exit::{Failure, warn};
use crate::cli::reports::{all, check_all, json, whole};
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
        let paths = [json, csv, svg, html].map(Option::as_deref);
        check_all(paths.into_iter().flatten())?;
        let [json, csv, svg, html] = paths;
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
        all([
            whole(self.json, || json(record)),
            whole(self.csv, || Ok(csv(record))),
            whole(self.svg, || svg(record).map_err(io::Error::other)),
            whole(self.html, || html(sheet)),
        ])
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

//! The files that an experiment leaves.

use std::io::{self, Write};
use std::path::Path;

use super::arguments::ConvergeArguments;
use crate::cli::exit::Failure;
use crate::image::file::{FileError, check_writable, write_whole};
use crate::report::convergence::{Convergence, csv, svg};

/// Each known to be writable when the experiment starts.
pub struct Outputs<'a> {
    json: Option<&'a Path>,
    csv: Option<&'a Path>,
    svg: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a ConvergeArguments) -> Result<Self, Failure> {
        let all = [&arguments.json, &arguments.csv, &arguments.svg].map(Option::as_deref);
        let checked = all.into_iter().flatten().map(check_writable);
        failed(checked.filter_map(Result::err).collect())?;
        let [json, csv, svg] = all;
        Ok(Self { json, csv, svg })
    }

    /// Writes what was asked for.
    pub fn write(&self, record: &Convergence) -> Result<(), Failure> {
        let json = || {
            let text = serde_json::to_string_pretty(record)?;
            Ok(text + "\n")
        };
        let written = [
            whole(self.json, json),
            whole(self.csv, || Ok(csv(record))),
            whole(self.svg, || svg(record).map_err(io::Error::other)),
        ];
        failed(written.into_iter().filter_map(Result::err).collect())
    }
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

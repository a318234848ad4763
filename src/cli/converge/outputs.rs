//! The files that an experiment leaves.

use std::io::{self, Write};
use std::path::Path;

use super::arguments::ConvergeArguments;
use crate::cli::exit::Failure;
use crate::image::file::{FileError, check_writable, write_whole};
use crate::report::convergence::{Convergence, csv};

/// Each known to be writable when the experiment starts.
pub struct Outputs<'a> {
    json: Option<&'a Path>,
    csv: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a ConvergeArguments) -> Result<Self, Failure> {
        let (json, csv) = (arguments.json.as_deref(), arguments.csv.as_deref());
        let checked = json.into_iter().chain(csv).map(check_writable);
        failed(checked.filter_map(Result::err).collect())?;
        Ok(Self { json, csv })
    }

    /// Writes what was asked for.
    pub fn write(&self, record: &Convergence) -> Result<(), Failure> {
        let json = |out: &mut dyn Write| -> io::Result<()> {
            serde_json::to_writer_pretty(&mut *out, record)?;
            writeln!(out)
        };
        let json = self.json.map(|path| write_whole(path, |out| json(out)));
        let text = csv(record);
        let csv = self
            .csv
            .map(|path| write_whole(path, |out| out.write_all(text.as_bytes())));
        let written = json.into_iter().chain(csv);
        failed(written.filter_map(Result::err).collect())
    }
}

fn failed(errors: Vec<FileError>) -> Result<(), Failure> {
    match errors.is_empty() {
        true => Ok(()),
        false => Err(Failure::Files(errors)),
    }
}

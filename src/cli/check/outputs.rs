//! The files that a run of the battery leaves.

use std::io;
use std::path::Path;

use super::arguments::CheckArguments;
use crate::cli::exit::Failure;
use crate::cli::reports::{all, check_all, json, whole};
use crate::report::check::{Sheet, page};

/// Each known to be writable when the battery starts.
pub struct Outputs<'a> {
    json: Option<&'a Path>,
    html: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a CheckArguments) -> Result<Self, Failure> {
        let [json, html] = [&arguments.json, &arguments.html].map(Option::as_deref);
        check_all(json.into_iter().chain(html))?;
        Ok(Self { json, html })
    }

    /// Writes what was asked for.
    pub fn write(&self, sheet: &Sheet) -> Result<(), Failure> {
        all([
            whole(self.json, || json(sheet.record)),
            whole(self.html, || page(sheet).map_err(io::Error::other)),
        ])
    }
}

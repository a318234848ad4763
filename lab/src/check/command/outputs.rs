//! The files that a run of the battery writes.

use std::io;

use super::arguments::CheckArguments;
use crate::check::report::{Sheet, page};
use crate::cli::destination::{Destination, Written, json, whole};

/// The files that the command line requests.
pub fn files(arguments: &CheckArguments) -> impl Iterator<Item = &Destination> {
    [&arguments.json, &arguments.html].into_iter().flatten()
}

/// Writes them.
pub fn write(arguments: &CheckArguments, sheet: &Sheet) -> [Written; 2] {
    [
        whole(&arguments.json, || json(sheet.record)),
        whole(&arguments.html, || page(sheet).map_err(io::Error::other)),
    ]
}

//! Writes the files that packages contain besides the program: man pages, and completions for shells.
//!
//! ```sh
//! cargo run --example packaging -- target/packaging
//! ```

#![allow(clippy::print_stderr, reason = "a program of its own")]

mod files;

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1) else {
        eprintln!("usage: packaging FOLDER");
        return ExitCode::from(2);
    };
    match files::write(Path::new(&folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}: {error}", Path::new(&folder).display());
            ExitCode::FAILURE
        }
    }
}

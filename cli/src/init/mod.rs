//! `vkpt init`: a first scene, whose comments explain the language.

use std::io;
use std::path::Path;

use vkpt::image::file::FileError;
use vkpt::shell::quoted;
use vkpt_lab::cli::destination::{Destination, all_written};
use vkpt_lab::cli::exit::{Ending, Failure, note};
use vkpt_lab::cli::writable;

/// The scene.
const SCENE: &str = include_str!("scene.txt");

const AFTER_HELP: &str = "\
Exit codes:
    0  written
    2  the command line is wrong
    5  the file exists already, or it or stdout could not be written

Examples:
  vkpt init              write scene.txt; vkpt scene.txt renders it
  vkpt init mine.txt     write it under another name";

/// Where the scene goes.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct InitArguments {
    /// File to write, which must not exist; - for stdout
    #[arg(value_name = "FILE", default_value = "scene.txt")]
    pub file: Destination,
}

/// Writes the scene, without replacing a file.
pub fn init(arguments: &InitArguments) -> Result<Ending, Failure> {
    let to = &arguments.file;
    let _claims = writable::check([to])?;
    if let Some(path) = to
        .neighbour()
        .filter(|path| path.symlink_metadata().is_ok())
    {
        let cause = io::Error::other("it exists already; give the scene another name");
        let path = path.to_owned();
        return Err(Failure::Files(vec![FileError { path, cause }]));
    }
    all_written([to.write(|out| out.write_all(SCENE.as_bytes()))])?;
    if let Some(name) = to.path().and_then(Path::to_str) {
        note(&format!("vkpt {} renders it", quoted(name)));
    }
    Ok(Ending::Complete)
}

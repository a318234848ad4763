//! The files that a rendering leaves.

use super::arguments::RenderArguments;
use super::pictures::{Picture, beside, pictures};
use crate::cli::console::Console;
use crate::cli::destination::Destination;
use crate::cli::exit::Failure;
use crate::cli::writable;
use crate::film::Aov;
use crate::image::file::FileError;
use crate::image::{Frame, Labels, encode};

/// Pictures and report, each known to be writable when the rendering starts.
#[derive(Debug)]
pub struct Outputs<'a> {
    pub pictures: Vec<Picture>,
    /// Standard errors; none if nobody asks.
    pub stderr: Vec<Picture>,
    pub json: &'a Option<Destination>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a RenderArguments) -> Result<Self, Failure> {
        let pictures = pictures(&arguments.output, arguments.format, arguments.scene()?)?;
        let stderr = match arguments.aov.contains(&Aov::Stderr) {
            true => beside(&pictures, arguments.spp())?,
            false => Vec::new(),
        };
        let json = &arguments.json;
        let outputs = Self {
            pictures,
            stderr,
            json,
        };
        writable::check(outputs.all())?;
        Ok(outputs)
    }

    /// Where text for people goes.
    pub fn console(&self) -> Console {
        Console::beside(self.all())
    }

    /// All of them.
    pub fn all(&self) -> impl Iterator<Item = &Destination> {
        let pictures = self.pictures.iter().chain(&self.stderr);
        pictures.map(|picture| &picture.to).chain(self.json)
    }
}

/// Writes the frame to every file that can be written, for what cost hours is not lost for another's disk; which
/// files are there now, and why others are not.
pub fn write_frame(
    files: &[Picture],
    frame: &Frame,
    labels: &Labels,
) -> (Vec<String>, Vec<FileError>) {
    let (mut written, mut errors) = (Vec::new(), Vec::new());
    for Picture { to, format } in files {
        match to.write(|mut out| encode(frame, *format, labels, &mut out)) {
            Ok(()) => written.push(to.to_string()),
            Err(error) => errors.push(error),
        }
    }
    (written, errors)
}

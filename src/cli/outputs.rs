//! The files that a rendering leaves.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::arguments::{RenderArguments, usage};
use super::exit::Failure;
use super::values::Output;
use crate::image::file::{FileError, check_writable, write_whole};
use crate::image::{Format, Frame, Labels, encode};
use crate::report::Record;

/// Pictures and report, each known to be writable when the rendering starts.
#[derive(Debug)]
pub struct Outputs<'a> {
    pub pictures: Vec<Output>,
    pub json: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a RenderArguments) -> Result<Self, Failure> {
        let mut pictures = arguments.output.clone();
        if pictures.is_empty() {
            pictures = default_pictures(arguments.scene()?)?;
        }
        let json = arguments.json.as_deref();
        let paths = pictures
            .iter()
            .map(|picture| picture.path.as_path())
            .chain(json);
        let errors: Vec<FileError> = paths
            .filter_map(|path| check_writable(path).err())
            .collect();
        if errors.is_empty() {
            Ok(Self { pictures, json })
        } else {
            Err(Failure::Files(errors))
        }
    }

    /// Writes every picture that can be written: what cost hours is not lost for another's disk.
    pub fn write_pictures(&self, frame: &Frame, labels: &Labels) -> Vec<FileError> {
        let write = |picture: &Output| {
            write_whole(&picture.path, |out| {
                encode(frame, picture.format, labels, out)
            })
            .err()
        };
        self.pictures.iter().filter_map(write).collect()
    }

    /// Writes the record, if it was asked for.
    pub fn write_json(&self, record: &Record) -> Option<FileError> {
        let write = |out: &mut dyn Write| -> io::Result<()> {
            serde_json::to_writer_pretty(&mut *out, record)?;
            writeln!(out)
        };
        self.json
            .and_then(|path| write_whole(path, |out| write(out)).err())
    }
}

/// The scene's name with both endings, in the working directory.
fn default_pictures(scene: &Path) -> Result<Vec<Output>, Failure> {
    let name = scene
        .file_stem()
        .ok_or_else(|| usage("the scene has no file name to call pictures by: use -o"))?;
    let picture = |ending: &str, format| {
        let mut file = name.to_os_string();
        file.push(ending);
        Output {
            path: PathBuf::from(file),
            format,
        }
    };
    Ok(vec![
        picture(".png", Format::Png),
        picture(".exr", Format::Exr),
    ])
}

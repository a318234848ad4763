//! The files that a rendering leaves.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::arguments::RenderArguments;
use crate::cli::exit::Failure;
use crate::cli::values::Output;
use crate::film::Aov;
use crate::image::file::{FileError, check_writable, stderr_path, write_whole};
use crate::image::{Format, Frame, Labels, encode};
use crate::report::Record;

/// Pictures and report, each known to be writable when the rendering starts.
#[derive(Debug)]
pub struct Outputs<'a> {
    pub pictures: Vec<Output>,
    /// Standard errors, one file for all pictures that differ in their ending alone; none if nobody asks.
    pub stderr: Vec<Output>,
    pub json: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for, and whether it can be written; touches nothing.
    pub fn check(arguments: &'a RenderArguments) -> Result<Self, Failure> {
        let mut pictures = arguments.output.clone();
        if pictures.is_empty() {
            pictures = default_pictures(arguments.scene()?)?;
        }
        let stderr = match arguments.aov.contains(&Aov::Stderr) {
            true => stderr_files(&pictures, arguments.spp())?,
            false => Vec::new(),
        };
        let json = arguments.json.as_deref();
        let films = pictures.iter().chain(&stderr);
        let paths = films.map(|file| file.path.as_path()).chain(json);
        let errors: Vec<FileError> = paths
            .filter_map(|path| check_writable(path).err())
            .collect();
        if errors.is_empty() {
            Ok(Self {
                pictures,
                stderr,
                json,
            })
        } else {
            Err(Failure::Files(errors))
        }
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

/// Writes the frame to every file that can be written, for what cost hours is not lost for another's disk; which
/// files are there now, and why others are not.
pub fn write_frame(
    files: &[Output],
    frame: &Frame,
    labels: &Labels,
) -> (Vec<String>, Vec<FileError>) {
    let (mut written, mut errors) = (Vec::new(), Vec::new());
    for Output { path, format } in files {
        match write_whole(path, |out| encode(frame, *format, labels, out)) {
            Ok(()) => written.push(path.display().to_string()),
            Err(error) => errors.push(error),
        }
    }
    (written, errors)
}

/// `NAME-stderr.exr` beside each picture `NAME.png` or `NAME.exr`.
fn stderr_files(pictures: &[Output], spp: u32) -> Result<Vec<Output>, Failure> {
    if spp < 2 {
        return Err(Failure::Usage(
            "--aov stderr needs --spp 2 or more: one sample tells nothing of its error".to_owned(),
        ));
    }
    let mut files: Vec<Output> = Vec::new();
    for picture in pictures {
        let path = stderr_path(&picture.path);
        if pictures.iter().any(|other| other.path == path) {
            return Err(Failure::Usage(format!(
                "--aov stderr would write over the picture {}: give it another name",
                path.display()
            )));
        }
        if files.iter().all(|other| other.path != path) {
            let format = Format::Exr;
            files.push(Output { path, format });
        }
    }
    Ok(files)
}

/// The scene's name with both endings, in the working directory.
fn default_pictures(scene: &Path) -> Result<Vec<Output>, Failure> {
    let name = scene.file_stem().ok_or_else(|| {
        Failure::Usage("the scene has no file name to call pictures by: use -o".to_owned())
    })?;
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

//! The folder of a farm.

use std::fs;
use std::path::{Path, PathBuf};

use crate::farm::{Farm, slurm};
use vkpt::image::file::FileError;
use vkpt::shell::quoted;
use vkpt_lab::cli::destination::{Destination, all_written};
use vkpt_lab::cli::exit::Failure;

/// A farm, and where its scripts go.
#[derive(Debug)]
pub struct Folder {
    pub path: PathBuf,
    pub farm: Farm,
}

impl Folder {
    /// A folder whose name Slurm takes as it is, and in which nothing has been rendered.
    pub fn new(path: PathBuf, farm: Farm) -> Result<Self, Failure> {
        let name = path.display();
        if farm.folder.contains(['%', '\\']) {
            return Err(Failure::Usage(format!(
                "Slurm reads % and \\ in {name} as its own: give pictures another name or place by -o"
            )));
        }
        let folder = Self { path, farm };
        match folder.path.join("parts").exists() {
            true => Err(Failure::Usage(format!(
                "{} contains parts of a rendering: `bash {}` goes on with it. Remove the folder to begin anew",
                folder.path.display(),
                quoted(&folder.submit().to_string_lossy())
            ))),
            false => Ok(folder),
        }
    }

    /// The script that submits it.
    pub fn submit(&self) -> PathBuf {
        self.path.join("submit.sh")
    }

    /// Writes all its files, over those that are there.
    pub fn write(&self) -> Result<(), Failure> {
        let made = fs::create_dir_all(&self.path).map_err(|cause| FileError {
            path: self.path.clone(),
            cause,
        });
        all_written([made])?;
        let written = slurm(&self.farm).into_iter().map(|script| {
            let to = Destination::File(self.path.join(script.name));
            to.write(|out| out.write_all(script.text.as_bytes()))
        });
        all_written(written)
    }
}

/// The absolute path of a file, as a script can contain it.
pub fn text(path: &Path) -> Result<String, Failure> {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match absolute.to_str() {
        Some(text) if !text.contains(char::is_control) => Ok(text.to_owned()),
        _ => Err(Failure::Usage(format!(
            "{} cannot stand in a script: it must be UTF-8 without control characters. Give it another name",
            absolute.display()
        ))),
    }
}

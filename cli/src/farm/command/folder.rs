//! The folder of a farm.

use std::fs;
use std::path::{Path, PathBuf};

use crate::farm::{Farm, slurm};
use vkpt::image::file::FileError;
use vkpt::shell::quoted;
use vkpt_lab::cli::destination::{Destination, all_written};
use vkpt_lab::cli::exit::Failure;

/// A farm, and the folder of its scripts.
#[derive(Debug)]
pub struct Folder {
    pub path: PathBuf,
    pub farm: Farm,
}

impl Folder {
    /// A folder whose name Slurm accepts, and in which nothing has been rendered.
    pub fn new(path: PathBuf, farm: Farm) -> Result<Self, Failure> {
        let name = path.display();
        if farm.folder.contains(['%', '\\']) {
            return Err(Failure::Usage(format!(
                "Slurm gives % and \\ in {name} a meaning of its own: choose another name or folder with -o"
            )));
        }
        let folder = Self { path, farm };
        match folder.path.join("parts").exists() {
            true => Err(Failure::Usage(format!(
                "{} contains parts of a rendering: continue it with `bash {}`, or remove the folder to start over",
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

    /// Writes all its files, replacing existing ones.
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

/// The absolute path of a file, in a form that a script can contain.
pub fn text(path: &Path) -> Result<String, Failure> {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match absolute.to_str() {
        Some(text) if !text.contains(char::is_control) => Ok(text.to_owned()),
        _ => Err(Failure::Usage(format!(
            "{} cannot be written in a script: rename it to UTF-8 without control characters",
            absolute.display()
        ))),
    }
}

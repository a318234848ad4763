//! Where a scene comes from: a file, or for `-` stdin.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::{Path, PathBuf};

use vkpt::scene::{self, Errors, Read};

/// What the argument SCENE names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// `-`
    Stdin,
    File(PathBuf),
    /// What a program that calls has in memory.
    Text(String),
}

impl From<OsString> for Source {
    fn from(word: OsString) -> Self {
        match word.to_str() {
            Some("-") => Self::Stdin,
            _ => Self::File(word.into()),
        }
    }
}

impl Source {
    /// Reads the scene, seen by the camera of that name. Meshes are looked for in the folder of the file, all others' in the
    /// working directory.
    pub fn read(&self, strict: bool, camera: Option<&str>) -> Result<Read, Errors> {
        match self {
            Self::Stdin => scene::read_from(io::stdin(), Path::new(STDIN), strict, camera),
            Self::File(path) => scene::read_seen(path, strict, camera),
            Self::Text(text) => scene::read_from(text.as_bytes(), Path::new(TEXT), strict, camera),
        }
    }

    /// What messages and reports call it.
    pub fn name(&self) -> String {
        match self {
            Self::Stdin => STDIN.to_owned(),
            Self::File(path) => path.display().to_string(),
            Self::Text(_) => TEXT.to_owned(),
        }
    }

    /// The word that names it on a command line.
    pub fn word(&self) -> String {
        match self {
            Self::Stdin | Self::Text(_) => "-".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    /// What pictures without a name of their own are called by.
    pub fn stem(&self) -> Option<&OsStr> {
        match self {
            Self::Stdin | Self::Text(_) => Some(OsStr::new("stdin")),
            Self::File(path) => path.file_stem(),
        }
    }
}

const STDIN: &str = "<stdin>";
const TEXT: &str = "<text>";

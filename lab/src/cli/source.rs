//! The source of a scene: a file, or stdin for `-`.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::{Path, PathBuf};

use vkpt::scene::{self, Errors, Read};

/// The value of the argument SCENE.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// `-`
    Stdin,
    File(PathBuf),
    /// Text of a calling program.
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
    /// Reads the scene, with the camera of that name. Meshes of a file are searched in its folder, those of other sources in
    /// the working directory.
    pub fn read(&self, strict: bool, camera: Option<&str>) -> Result<Read, Errors> {
        match self {
            Self::Stdin => scene::read_from(io::stdin(), Path::new(STDIN), strict, camera),
            Self::File(path) => scene::read_seen(path, strict, camera),
            Self::Text(text) => scene::read_from(text.as_bytes(), Path::new(TEXT), strict, camera),
        }
    }

    /// Its name in messages and reports.
    pub fn name(&self) -> String {
        match self {
            Self::Stdin => STDIN.to_owned(),
            Self::File(path) => path.display().to_string(),
            Self::Text(_) => TEXT.to_owned(),
        }
    }

    /// Its name on a command line.
    pub fn word(&self) -> String {
        match self {
            Self::Stdin | Self::Text(_) => "-".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    /// The stem of the names of default outputs.
    pub fn stem(&self) -> Option<&OsStr> {
        match self {
            Self::Stdin | Self::Text(_) => Some(OsStr::new("stdin")),
            Self::File(path) => path.file_stem(),
        }
    }
}

const STDIN: &str = "<stdin>";
const TEXT: &str = "<text>";

//! Open Image Denoise: finds its library, and converts pictures.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use super::{Features, OidnError};
use crate::film::Film;
use crate::gpu::oidn::{Oidn as Library, Pixels};

/// The loaded library.
pub struct Oidn(Library);

/// Its names; the system's loader finds libraries installed by a package manager.
#[cfg(target_os = "windows")]
const NAMES: [&str; 1] = ["OpenImageDenoise.dll"];
#[cfg(target_os = "macos")]
const NAMES: [&str; 2] = ["libOpenImageDenoise.2.dylib", "libOpenImageDenoise.dylib"];
#[cfg(not(any(target_os = "windows", target_os = "macos")))]
const NAMES: [&str; 2] = ["libOpenImageDenoise.so.2", "libOpenImageDenoise.so"];

/// Its path in PyPI's `pyoidn`, relative to a folder of Python packages.
const IN_PACKAGES: &str = "pyoidn/oidn/lib";

impl Oidn {
    /// Loads the library at `path`, or in the folder `path`.
    ///
    /// # Errors
    /// It is missing, too old or broken.
    pub fn at(path: &Path) -> Result<Self, OidnError> {
        let file = match path.is_dir() {
            true => NAMES
                .map(|name| path.join(name))
                .into_iter()
                .find(|file| file.exists()),
            false => Some(path.to_owned()),
        };
        match file {
            Some(file) if file.exists() => {
                // The loader would search for a bare name elsewhere.
                let file = std::path::absolute(&file).unwrap_or(file);
                Library::load(file.as_os_str()).map(Self)
            }
            _ => Err(OidnError::NoLibrary(format!("{} does not exist", NAMES[0]))),
        }
    }

    /// Loads the library through the system's loader, or else from one of `folders`; `None` if it is in none of these.
    ///
    /// # Errors
    /// The first one found is broken or too old.
    pub fn found(folders: &[PathBuf]) -> Result<Option<Self>, OidnError> {
        for name in NAMES {
            match Library::load(OsStr::new(name)) {
                Ok(library) => return Ok(Some(Self(library))),
                Err(OidnError::NoLibrary(_)) => {}
                Err(error) => return Err(error),
            }
        }
        let there = |folder: &&PathBuf| NAMES.iter().any(|name| folder.join(name).exists());
        let first = folders.iter().find(there);
        first.map(|folder| Self::at(folder)).transpose()
    }

    /// Such as 2.5.1.
    pub fn version(&self) -> String {
        self.0.version()
    }

    /// A denoised picture, of the same size.
    pub fn denoise(&self, picture: &Film, features: &Features) -> Result<Film, OidnError> {
        let [albedo, normal] = [&features.albedo, &features.normal].map(pixels);
        let denoised = self.0.denoise(&pixels(picture), Some([&albedo, &normal]))?;
        Ok(Film {
            rgb: denoised.values,
            ..*picture
        })
    }
}

fn pixels(film: &Film) -> Pixels {
    Pixels {
        width: film.width as usize,
        height: film.height as usize,
        values: film.rgb.clone(),
    }
}

/// The folders of Python packages in which `pip install pyoidn` puts it: those of the virtual environment, the user and
/// the system.
pub fn usual_places(variable: impl Fn(&str) -> Option<OsString>) -> Vec<PathBuf> {
    let roots = [
        variable("VIRTUAL_ENV").map(PathBuf::from),
        variable("CONDA_PREFIX").map(PathBuf::from),
        variable("HOME").map(|home| PathBuf::from(home).join(".local")),
        Some("/usr/local".into()),
        Some("/usr".into()),
    ];
    let packages = |root: PathBuf| {
        let libraries = std::fs::read_dir(root.join("lib")).into_iter().flatten();
        let pythons = libraries.filter_map(Result::ok).map(|entry| entry.path());
        let mut pythons: Vec<PathBuf> = pythons.filter(|path| is_python(path)).collect();
        pythons.sort();
        pythons
    };
    let folders = |python: PathBuf| {
        ["site-packages", "dist-packages"].map(|name| python.join(name).join(IN_PACKAGES))
    };
    let all = roots
        .into_iter()
        .flatten()
        .flat_map(packages)
        .flat_map(folders);
    all.filter(|folder| folder.is_dir()).collect()
}

fn is_python(path: &Path) -> bool {
    let name = path.file_name().and_then(OsStr::to_str);
    name.is_some_and(|name| name.starts_with("python3"))
}

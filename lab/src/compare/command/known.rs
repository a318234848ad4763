//! A picture and its standard errors.

use std::path::{Path, PathBuf};

use super::arguments::PictureArguments;
use super::comparand::Comparand;
use crate::cli::beside::layer;
use crate::cli::exit::Failure;
use crate::cli::inputs::Input;
use crate::cli::stderr::{belongs, standard_errors};
use vkpt::film::Film;
use vkpt::image::file::stderr_path;
use vkpt::image::{self, Picture, Precision};
use vkpt::metrics::StandardErrors;
use vkpt::metrics::blocks::{Estimate, Stderr};

/// A picture, and its standard errors, if known.
pub struct Known {
    pub path: PathBuf,
    pub picture: Picture,
    stderr: Option<Errors>,
}

/// Standard errors.
struct Errors {
    /// Their file, if they come from one.
    path: Option<PathBuf>,
    film: Film,
    freedom: f64,
}

impl Known {
    /// A picture that a program names or passes.
    pub fn new(of: Comparand) -> Result<Self, Failure> {
        match of {
            Comparand::File(path) => {
                let stderr = Some(stderr_path(&path)).filter(|path| path.exists());
                Self::read(&path, stderr, None).map_err(Failure::Pictures)
            }
            Comparand::Memory {
                name,
                film,
                origin,
                stderr,
            } => Ok(Self::in_memory(name, film, origin, stderr)),
        }
    }

    fn in_memory(
        name: String,
        film: Film,
        crop: Option<[u32; 2]>,
        stderr: Option<(Film, f64)>,
    ) -> Self {
        let size = [film.width, film.height];
        let [x, y] = crop.unwrap_or_default();
        let stderr = stderr.map(|(film, freedom)| Errors {
            path: None,
            film,
            freedom,
        });
        Self {
            path: name.into(),
            picture: Picture {
                film,
                origin: [x as i32, y as i32],
                // No crop is as large as its picture: how large does not matter here.
                full: match crop {
                    Some(_) => [u32::MAX; 2],
                    None => size,
                },
                precision: Precision::Single,
                notes: String::new(),
            },
            stderr,
        }
    }

    /// All pictures of the command line, the reference last.
    pub fn read_all(arguments: &PictureArguments) -> Result<Vec<Self>, Failure> {
        let count = arguments.paths().count();
        let errors = match &arguments.stderr[..] {
            // The files contain the errors of the picture, not of a layer.
            [] if arguments.layer.is_some() => arguments.paths().map(|_| None).collect(),
            [] => arguments
                .paths()
                .map(|path| Some(stderr_path(path)).filter(|path| path.exists()))
                .collect(),
            given if given.len() == count => given.iter().cloned().map(Some).collect(),
            given => {
                return Err(Failure::Usage(format!(
                    "--stderr must be given once for each picture, in the order A, B, reference: {} given, {} needed",
                    given.len(),
                    count
                )));
            }
        };
        let errors: Vec<Option<PathBuf>> = errors;
        let (mut known, mut wrong) = (Vec::new(), Vec::new());
        for (path, stderr) in arguments.paths().zip(errors) {
            match Self::read(path, stderr, arguments.layer.as_deref()) {
                Ok(picture) => known.push(picture),
                Err(messages) => wrong.extend(messages),
            }
        }
        match wrong.is_empty() {
            true => Ok(known),
            false => Err(Failure::Pictures(wrong)),
        }
    }

    /// Picture and standard errors, which must belong to it; otherwise all errors.
    fn read(path: &Path, stderr: Option<PathBuf>, name: Option<&str>) -> Result<Self, Vec<String>> {
        let picture = match name {
            Some(name) => image::read_layer(path, &layer(name)),
            None => image::read(path),
        };
        let errors = stderr.map(|path| image::read(&path).map(|errors| (path, errors)));
        match (picture, errors.transpose()) {
            (Ok(picture), Ok(stderr)) => {
                if let Some((file, errors)) = &stderr {
                    let advice = "name the right one with --stderr";
                    belongs((file, errors), (path, &picture), advice).map_err(|e| vec![e])?;
                }
                Ok(Self {
                    path: path.to_owned(),
                    picture,
                    stderr: stderr.map(|(file, picture)| Errors {
                        freedom: standard_errors(&picture).freedom,
                        path: Some(file),
                        film: picture.film,
                    }),
                })
            }
            (picture, errors) => {
                let all = [picture.err(), errors.err()].into_iter().flatten();
                Err(all.map(|error| error.to_string()).collect())
            }
        }
    }

    /// The files that it was read from.
    pub fn inputs(&self) -> impl Iterator<Item = Input> {
        let errors = self.stderr.iter().filter_map(|e| e.path.as_ref());
        let errors = errors.map(|path| Input::new("the standard errors of a picture", path));
        [Input::new("a picture to compare", &self.path)]
            .into_iter()
            .chain(errors)
    }

    pub fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// The picture with its standard errors; otherwise a message that says which are missing.
    pub fn estimate(&self) -> Result<Estimate<'_>, String> {
        let Errors { film, freedom, .. } = self.stderr.as_ref().ok_or_else(|| {
            format!(
                "no standard errors of {}: render with --aov stderr, which writes them to {}, or name them with --stderr",
                self.name(),
                stderr_path(&self.path).display()
            )
        })?;
        Ok(Estimate {
            mean: &self.picture.film,
            stderr: Stderr::PerPixel(StandardErrors {
                film,
                freedom: *freedom,
            }),
            precision: self.picture.precision,
        })
    }

    /// Two crops of equal size may still show different places.
    pub fn same_place(&self, other: &Self) -> Result<(), Vec<String>> {
        let is_crop = |p: &Picture| p.full != [p.film.width, p.film.height];
        let (a, b) = (&self.picture, &other.picture);
        if is_crop(a) && is_crop(b) && a.origin != b.origin {
            return Err(vec![format!(
                "{} and {} are crops of different places: one begins at {},{}, the other at {},{}",
                self.name(),
                other.name(),
                a.origin[0],
                a.origin[1],
                b.origin[0],
                b.origin[1]
            )]);
        }
        Ok(())
    }
}

//! A picture and how well it is known.

use std::path::PathBuf;

use super::arguments::PictureArguments;
use crate::cli::exit::Failure;
use crate::cli::stderr::standard_errors;
use crate::image::file::stderr_path;
use crate::image::{self, Picture};
use crate::metrics::blocks::{Estimate, Stderr};

/// A picture, and its standard errors where there are any.
pub struct Known {
    pub path: PathBuf,
    pub picture: Picture,
    stderr: Option<Picture>,
}

impl Known {
    /// All pictures of the command line, the one to judge by last.
    pub fn read_all(arguments: &PictureArguments) -> Result<Vec<Self>, Failure> {
        let count = arguments.paths().count();
        let errors = match &arguments.stderr[..] {
            [] => arguments
                .paths()
                .map(|path| Some(stderr_path(path)).filter(|path| path.exists()))
                .collect(),
            given if given.len() == count => given.iter().cloned().map(Some).collect(),
            given => {
                return Err(Failure::Usage(format!(
                    "--stderr must be given once for each picture, in the order A, B, reference: {} of {}",
                    given.len(),
                    count
                )));
            }
        };
        let errors: Vec<Option<PathBuf>> = errors;
        let (mut known, mut unreadable) = (Vec::new(), Vec::new());
        for (path, stderr) in arguments.paths().zip(&errors) {
            let stderr = stderr.as_deref().map(image::read).transpose();
            match (image::read(path), stderr) {
                (Ok(picture), Ok(stderr)) => known.push(Self {
                    path: path.clone(),
                    picture,
                    stderr,
                }),
                (a, b) => unreadable.extend([a.err(), b.err()].into_iter().flatten()),
            }
        }
        if unreadable.is_empty() {
            Ok(known)
        } else {
            let told = unreadable.iter().map(ToString::to_string);
            Err(Failure::Pictures(told.collect()))
        }
    }

    pub fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// The picture with its standard errors; otherwise what is missing.
    pub fn estimate(&self) -> Result<Estimate<'_>, String> {
        let stderr = self.stderr.as_ref().ok_or_else(|| {
            format!(
                "there are no standard errors of {}: vkpt writes them with --aov stderr to {}, --stderr names others",
                self.name(),
                stderr_path(&self.path).display()
            )
        })?;
        Ok(Estimate {
            mean: &self.picture.film,
            stderr: Stderr::PerPixel(standard_errors(stderr)),
            precision: self.picture.precision,
        })
    }

    /// Two crops of one size may still show different places.
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

//! The files of a rendering: pictures and those next to them, parts, and the report.

use std::path::Path;

use super::arguments::OutputArguments;
use super::pictures::{Picture, beside, denoised, pictures};
use vkpt::film::Aov;
use vkpt::image::Format;
use vkpt::state;
use vkpt_lab::cli::beside::Beside;
use vkpt_lab::cli::console::Console;
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::exit::Failure;

/// Pictures, parts and report.
#[derive(Debug)]
pub struct Outputs<'a> {
    pub arguments: &'a OutputArguments,
    pub(super) pictures: Vec<Picture>,
    /// Standard errors; none if not requested.
    pub(super) stderr: Vec<Picture>,
    /// Denoised pictures; none if not requested.
    pub(super) denoised: Vec<Picture>,
    /// Files that --resume can continue.
    pub parts: Vec<Destination>,
}

impl<'a> Outputs<'a> {
    /// The outputs that the command line requests, for `spp` samples; without `-o`, those of `default`.
    pub fn new(
        arguments: &'a OutputArguments,
        spp: u32,
        default: impl FnOnce() -> Result<Vec<Destination>, Failure>,
    ) -> Result<Self, Failure> {
        let given = match &arguments.output[..] {
            [] => default()?,
            given => given.to_vec(),
        };
        let (parts, rest): (Vec<_>, Vec<_>) = given.into_iter().partition(is_part);
        let pictures = pictures(&rest, arguments.format)?;
        check_layers(arguments, &pictures)?;
        let stderr = match arguments.aov.contains(&Beside::Aov(Aov::Stderr)) && !pictures.is_empty()
        {
            true => beside(&pictures, spp)?,
            false => Vec::new(),
        };
        Ok(Self {
            arguments,
            pictures,
            stderr,
            denoised: Vec::new(),
            parts,
        })
    }

    /// With a denoised picture next to each.
    ///
    /// # Errors
    /// If no file can be written next to any, or it would replace a picture.
    pub fn with_denoised(self) -> Result<Self, Failure> {
        Ok(Self {
            denoised: denoised(&self.pictures)?,
            ..self
        })
    }

    /// Whether there are pictures, not only parts.
    pub fn has_pictures(&self) -> bool {
        !self.pictures.is_empty()
    }

    /// The name of the first picture that is a file.
    pub fn first_picture(&self) -> Option<&Path> {
        let mut files = self.pictures.iter().filter_map(|p| p.to.neighbour());
        files.next()
    }

    /// Where text for people goes.
    pub fn console(&self) -> Console {
        Console::beside(self.all())
    }

    /// All of them.
    pub fn all(&self) -> impl Iterator<Item = &Destination> {
        let pictures = self
            .pictures
            .iter()
            .chain(&self.stderr)
            .chain(&self.denoised);
        let pictures = pictures.map(|picture| &picture.to);
        pictures.chain(&self.parts).chain(&self.arguments.json)
    }
}

/// Layers need an EXR.
fn check_layers(arguments: &OutputArguments, pictures: &[Picture]) -> Result<(), Failure> {
    let layer = arguments.aov.iter().find(|aov| aov.is_layer());
    let has_exr = pictures.iter().any(|picture| picture.format == Format::Exr);
    match layer.filter(|_| !has_exr) {
        Some(layer) => Err(Failure::Usage(format!(
            "--aov {} is a layer of an EXR, but no EXR is written: add -o NAME.exr",
            layer
        ))),
        None => Ok(()),
    }
}

/// Whether its name says that it is a part of a picture.
pub fn is_part(to: &Destination) -> bool {
    let ending = to.path().and_then(|path| path.extension());
    ending.is_some_and(|ending| ending.eq_ignore_ascii_case(state::ENDING))
}

//! The exports to other renderers.

use std::fmt::Display;
use std::path::Path;

use crate::export::gltf::Container;
use crate::export::{Export, Remark, Subject, gltf, mitsuba, pbrt};
use vkpt::report::names::Named;
use vkpt::settings::Model;

/// Another renderer, or the format of many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Peer {
    Mitsuba,
    Pbrt,
    Gltf,
}

impl Named for Peer {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Mitsuba, "mitsuba"),
        (Self::Pbrt, "pbrt"),
        (Self::Gltf, "gltf"),
    ];
}

/// The ending of its files' names.
pub fn ending(peer: Peer) -> &'static str {
    match peer {
        Peer::Mitsuba => ".xml",
        Peer::Pbrt => ".pbrt",
        Peer::Gltf => ".glb",
    }
}

/// The flag that it has no equivalent of, and why.
pub fn setting(peer: Peer, model: &Model, crop: Option<[u32; 4]>) -> Option<&'static str> {
    match peer {
        Peer::Mitsuba => mitsuba::setting(model),
        Peer::Pbrt => pbrt::setting(model),
        Peer::Gltf => gltf::setting(model, crop),
    }
}

/// The scene in its language, for a file of the name `to`.
///
/// # Errors
/// Each line that it has no equivalent of, and why.
pub fn export(
    peer: Peer,
    subject: &Subject,
    to: Option<&Path>,
) -> Result<Export, Vec<Remark<String>>> {
    match peer {
        Peer::Mitsuba => mitsuba::export(subject).map_err(as_text),
        Peer::Pbrt => pbrt::export(subject).map_err(as_text),
        Peer::Gltf => gltf::export(subject, container(to)).map_err(as_text),
    }
}

fn as_text<R: Display>(refusals: Vec<Remark<R>>) -> Vec<Remark<String>> {
    refusals.into_iter().map(Remark::as_text).collect()
}

/// JSON if the name ends in .gltf, else GLB, which is one file.
fn container(to: Option<&Path>) -> Container {
    let ending = to.and_then(Path::extension);
    match ending.is_some_and(|ending| ending.eq_ignore_ascii_case("gltf")) {
        true => Container::Json,
        false => Container::Glb,
    }
}

//! `vkpt export SCENE`: a scene as another renderer reads it.

mod arguments;

use std::fmt::Display;
use std::path::Path;

use super::destination::{Destination, all_written};
use super::exit::{Ending, Failure};
use super::inputs::{Input, spare};
use super::job::{Loaded, Request};
use super::values::Peer;
use super::writable;
use crate::export::{Export, Remark, Subject, mitsuba};
pub use arguments::ExportArguments;

/// Writes the scene and its meshes, all that is said of it or nothing.
pub fn export(arguments: &ExportArguments) -> Result<Ending, Failure> {
    let to = output(arguments)?;
    // What cannot be written is told before the work; it is claimed below, with the meshes.
    drop(writable::check([&to])?);
    let request = arguments.request();
    if let Some(message) = setting(arguments.to, &request) {
        return Err(Failure::Usage(message.to_owned()));
    }
    let loaded = Loaded::new(&request)?;
    let ready = loaded.prepare(&request)?;
    let stem = to.path().and_then(Path::file_stem).unwrap_or_default();
    let subject = Subject {
        scene: &loaded.scene,
        prepared: &ready.prepared,
        model: &ready.settings.model,
        crop: ready.job(&request)?.crop,
        stem: &stem.to_string_lossy(),
    };
    let place = |line| loaded.place(&arguments.scene.name(), line);
    let export = match arguments.to {
        Peer::Mitsuba => told(mitsuba::export(&subject), place),
    }?;
    let places = (export.beside.iter())
        .map(|file| beside(&to, &file.name))
        .collect::<Result<Vec<_>, _>>()?;
    let _claims = writable::check(places.iter().chain([&to]))?;
    let inputs = Input::of_scene(request.scene, &loaded.scene);
    spare(&inputs, places.iter().chain([&to]))?;
    let written = (places.iter().zip(&export.beside))
        .map(|(to, file)| to.write(|out| out.write_all(&file.bytes)));
    // The scene last: where it is, its meshes are.
    all_written(written)?;
    all_written([to.write(|out| export.write(out))])?;
    Ok(Ending::Complete)
}

/// The flag that the other renderer has no equal of, and why.
fn setting(peer: Peer, request: &Request) -> Option<&'static str> {
    match peer {
        Peer::Mitsuba => mitsuba::setting(&request.settings.model),
    }
}

/// What is refused, told by the places of lines.
fn told<R: Display>(
    exported: Result<Export, Vec<Remark<R>>>,
    place: impl Fn(usize) -> String,
) -> Result<Export, Failure> {
    exported.map_err(|refusals| {
        let told = (refusals.iter()).map(|r| format!("{}: {r}", place(r.line)));
        Failure::Untranslatable(told.collect())
    })
}

/// The file of `-o`, else one named after the scene.
fn output(arguments: &ExportArguments) -> Result<Destination, Failure> {
    if let Some(to) = &arguments.output {
        return Ok(to.clone());
    }
    let Some(stem) = arguments.scene.stem() else {
        return Err(Failure::Usage(
            "the scene has no file name to call the export by: use -o".to_owned(),
        ));
    };
    let mut name = stem.to_os_string();
    name.push(".xml");
    Ok(Destination::File(name.into()))
}

/// Where a mesh goes.
fn beside(to: &Destination, name: &str) -> Result<Destination, Failure> {
    match to.neighbour() {
        Some(path) => Ok(Destination::File(path.with_file_name(name))),
        None => Err(Failure::Usage(format!(
            "meshes are written beside the scene, and {to} has no place beside it: use -o FILE"
        ))),
    }
}

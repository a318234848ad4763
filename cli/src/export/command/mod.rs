//! `vkpt export SCENE`: a scene as another renderer reads it.

mod arguments;
mod peer;

use std::path::Path;

use crate::export::{Remark, Subject};
pub use arguments::ExportArguments;
use vkpt_lab::cli::destination::{Destination, all_written};
use vkpt_lab::cli::exit::{Ending, Failure, note, warn};
use vkpt_lab::cli::inputs::{Input, spare};
use vkpt_lab::cli::job::Loaded;
use vkpt_lab::cli::writable;

/// Writes the scene and the files next to it, all of them or nothing.
pub fn export(arguments: &ExportArguments) -> Result<Ending, Failure> {
    let to = output(arguments)?;
    // Reports unwritable files before the work starts; files are claimed below, with those next to them.
    drop(writable::check([&to])?);
    let request = arguments.request();
    let model = &request.settings.model;
    if let Some(message) = peer::setting(arguments.to, model, request.crop) {
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
    let file = arguments.scene.name();
    let placed = |remarks: &[Remark<String>]| {
        let placed = |r: &Remark<String>| format!("{}: {r}", loaded.place(&file, r.line));
        remarks.iter().map(placed).collect::<Vec<_>>()
    };
    let export = peer::export(arguments.to, &subject, to.path())
        .map_err(|refusals| Failure::Untranslatable(placed(&refusals)))?;
    let warnings = placed(&export.warnings);
    if request.strict && !warnings.is_empty() {
        return Err(Failure::Strict(warnings));
    }
    warnings.iter().for_each(|what| warn(what));
    let notes = placed(export.note.as_slice());
    notes.iter().for_each(|what| note(what));
    let places = (export.beside.iter())
        .map(|file| beside(&to, &file.name))
        .collect::<Result<Vec<_>, _>>()?;
    let _claims = writable::check(places.iter().chain([&to]))?;
    let inputs = Input::of_scene(request.scene, &loaded.scene);
    spare(&inputs, places.iter().chain([&to]))?;
    let written = (places.iter().zip(&export.beside))
        .map(|(to, file)| to.write(|out| out.write_all(&file.bytes)));
    // The scene last: if it exists, so do the files that it names.
    all_written(written)?;
    all_written([to.write(|out| export.write(out))])?;
    Ok(Ending::Complete)
}

/// The file of `-o`, else one named after the scene.
fn output(arguments: &ExportArguments) -> Result<Destination, Failure> {
    if let Some(to) = &arguments.output {
        return Ok(to.clone());
    }
    let Some(stem) = arguments.scene.stem() else {
        return Err(Failure::Usage(
            "the scene has no file name to derive the export's name from: use -o FILE".to_owned(),
        ));
    };
    let mut name = stem.to_os_string();
    name.push(peer::ending(arguments.to));
    Ok(Destination::File(name.into()))
}

/// The destination of a file next to the scene.
fn beside(to: &Destination, name: &str) -> Result<Destination, Failure> {
    match to.neighbour() {
        Some(path) => Ok(Destination::File(path.with_file_name(name))),
        None => Err(Failure::Usage(format!(
            "the export consists of several files, which cannot be written next to {to}: use -o FILE"
        ))),
    }
}

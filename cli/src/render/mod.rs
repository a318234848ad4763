//! `vkpt SCENE`: renders a scene to pictures.

mod arguments;
mod call;
mod develop;
mod record;
mod split;
mod trace;

use std::path::{Path, PathBuf};

use self::develop::{Goal, Made, develop};
use self::trace::trace;
use crate::keep::digest;
use crate::live::command::Doors;
use crate::outputs::{Outputs, Written, write};
pub use arguments::RenderArguments;
pub use call::{Growing, Rendered, rendered};
pub use record::{dropped, error, error_of, largest};
use vkpt::denoise::Denoiser;
use vkpt::image::file::check_writable;
use vkpt::render::{End, Job};
use vkpt::state::ENDING;
use vkpt_lab::cli::denoise::{denoised, load};
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::exit::{Ending, Failure, note, warn};
use vkpt_lab::cli::inputs::{Input, spare};
use vkpt_lab::cli::interrupt::stop_flag;
use vkpt_lab::cli::job::Loaded;
use vkpt_lab::cli::writable;

/// Reads, prepares, renders, writes and reports; or prints the path that `--trace` names.
pub fn render(arguments: &RenderArguments) -> Result<Ending, Failure> {
    if let Some(path) = arguments.trace {
        return trace(arguments, path);
    }
    let outputs = outputs(arguments)?;
    let kept = kept(arguments, &outputs)?;
    // A part of -o is one of the outputs already.
    let beside = kept.clone().filter(|_| outputs.parts.is_empty());
    let beside = beside.map(Destination::File);
    // Errors of the command line are reported first.
    let _claims = (writable::check(outputs.all())?, writable::check(&beside)?);
    let doors = Doors::new(&arguments.live)?;
    let request = arguments.request()?;
    let loaded = Loaded::new(&request)?;
    spare(
        &Input::of_scene(request.scene, &loaded.scene),
        outputs.all().chain(&beside),
    )?;
    let digest = match kept.is_some() || !outputs.parts.is_empty() {
        true => digest(&loaded.text, &loaded.scene).map_err(|error| {
            Failure::Usage(format!("cannot read a file of the scene again: {error}"))
        })?,
        false => String::new(),
    };
    let ready = loaded.prepare(&request)?;
    let goal = Goal {
        kept: kept.as_deref(),
        digest,
        pictures: outputs.has_pictures(),
    };
    let denoiser = arguments
        .denoise
        .denoise
        .map(|by| load(arguments.denoise.oidn.as_deref(), by));
    // A warning before the rendering, which proceeds without.
    if let Some(Err(why)) = &denoiser {
        warn(&format!("no denoised picture will be written: {why}"));
    }
    let asked = arguments.beside();
    let job = arguments.job(&ready, &asked)?;
    let stop = stop_flag();
    let mut viewers = arguments.viewers(doors, &stop)?;
    let made = develop(arguments, &ready, &job, goal, &stop, &mut viewers);
    let ending = made.and_then(|made| match made {
        None => Ok(Ending::Complete),
        Some(made) => finish(&outputs, made, kept, denoiser, &job),
    });
    viewers.ended(ending.is_ok());
    ending
}

/// Denoises, if requested and possible, and writes.
fn finish(
    outputs: &Outputs,
    made: Made,
    kept: Option<PathBuf>,
    denoiser: Option<Result<Denoiser, String>>,
    job: &Job,
) -> Result<Ending, Failure> {
    match denoiser {
        None => leave(outputs, made, kept, None),
        Some(Ok(denoiser)) => leave(outputs, made, kept, Some((&denoiser, job))),
        Some(Err(_)) => match leave(outputs, made, kept, None)? {
            Ending::Complete => Ok(Ending::Undenoised),
            ending => Ok(ending),
        },
    }
}

/// The requested files.
fn outputs(arguments: &RenderArguments) -> Result<Outputs<'_>, Failure> {
    let spp = arguments.range().len() as u32;
    let outputs = Outputs::new(&arguments.outputs, spp, || arguments.default_outputs())?;
    if arguments.denoise.denoise.is_some() {
        arguments.check_denoise()?;
        return outputs.with_denoised();
    }
    match arguments.samples.is_some() && outputs.has_pictures() {
        true => Err(Failure::Usage(
            "--samples renders a part of a picture, which needs a .vkpt file: use -o NAME.vkpt, and vkpt merge to make pictures".to_owned(),
        )),
        false => Ok(outputs),
    }
}

/// The file of checkpoints, which --resume continues: the first part of `-o`, else a file next to the first picture.
fn kept(arguments: &RenderArguments, outputs: &Outputs) -> Result<Option<PathBuf>, Failure> {
    let mut parts = outputs.parts.iter().filter_map(|to| to.neighbour());
    if let Some(part) = parts.next() {
        return Ok(Some(part.to_owned()));
    }
    let picture = outputs.first_picture();
    let beside = picture.map(|p| p.with_extension(ENDING));
    match (beside, arguments.resume, arguments.pause()) {
        (None, true, _) => Err(Failure::Usage(
            "--resume needs a file next to the first picture, which stdout, devices and pipes do not have: add -o FILE"
                .to_owned(),
        )),
        (beside, true, _) => Ok(beside),
        (_, false, None) => Ok(None),
        (beside, false, Some(_)) => Ok(beside.filter(|path| can_be_kept(path, picture))),
    }
}

/// Whether a part can be written next to the picture; if not, the rendering proceeds without. Errors of the picture's own
/// place are reported for the picture.
fn can_be_kept(path: &Path, picture: Option<&Path>) -> bool {
    if picture.is_some_and(|picture| check_writable(picture).is_err()) {
        return false;
    }
    let checked = check_writable(path);
    if let Err(error) = &checked {
        warn(&format!("cannot write checkpoints: {error}"));
    }
    checked.is_ok()
}

/// Writes the result, including its part if it is to be kept.
fn leave(
    outputs: &Outputs,
    made: Made,
    kept: Option<PathBuf>,
    denoise: Option<(&Denoiser, &Job)>,
) -> Result<Ending, Failure> {
    let Made {
        outcome,
        channels,
        header,
        freedom,
        checkpointed,
    } = made;
    if outcome.spp == 0 {
        warn("interrupted before the first sample was done: nothing was written");
        return Ok(Ending::Interrupted);
    }
    let early = matches!(outcome.end, End::Interrupted | End::Lost);
    let mut parts = outputs.parts.clone();
    if parts.is_empty() && (early || checkpointed) {
        parts.extend(kept.map(Destination::File));
    }
    let denoise = denoise.map(|(denoiser, job)| || denoised(denoiser, job, &outcome));
    let written = Written {
        film: &outcome.film,
        channels: &channels,
        stderr: outcome.stderr.as_ref().map(|film| (film, freedom)),
        part: &outcome.state.part,
        parts: &parts,
        header,
        denoised: denoise.as_ref().map(|denoise| denoise as _),
    };
    let ending = write(outputs, written)?;
    let part = parts.first().map(ToString::to_string);
    if let Some(why) = outcome.failure {
        return Err(Failure::Lost { why, part });
    }
    if let Some(part) = part.filter(|_| early && !outputs.arguments.quiet) {
        note(&format!("continue with --resume, which reads {part}"));
    }
    Ok(ending)
}

//! `vkpt SCENE`: renders a scene to pictures.

mod arguments;
mod outputs;
mod pictures;
mod record;
mod trace;

use std::time::Instant;

use self::outputs::{Outputs, write_frame};
use self::pictures::Picture;
use self::record::record;
use self::trace::trace;
use crate::cli::destination::{json, whole};
use crate::cli::exit::{Ending, Failure, warn};
use crate::cli::inputs::{Input, spare};
use crate::cli::interrupt::stop_flag;
use crate::cli::job::{Loaded, Ready};
use crate::cli::progress::Display;
use crate::film::Film;
use crate::image::file::FileError;
use crate::image::{Frame, Labels};
use crate::render::{self, Best, End, Outcome};
use crate::report::{self, Record, SOFTWARE};
pub use arguments::RenderArguments;

/// Reads, prepares, renders, writes and reports; or prints the path that `--trace` asks for.
pub fn render(arguments: &RenderArguments) -> Result<Ending, Failure> {
    if let Some(path) = arguments.trace {
        return trace(arguments, path);
    }
    let outputs = Outputs::check(arguments)?;
    let request = arguments.request()?;
    let loaded = Loaded::new(&request)?;
    spare(
        &Input::of_scene(request.scene, &loaded.scene),
        outputs.all(),
    )?;
    let ready = loaded.prepare(&request)?;
    let (best, outcome) = develop(arguments, &ready)?;
    if outcome.spp == 0 {
        warn("interrupted before the first sample was done: nothing is written");
        return Ok(Ending::Interrupted);
    }
    let mut record = record(arguments, &ready, &best, &outcome)?;
    let mut errors = write(arguments, &outputs, &outcome, &mut record);
    report::concerns(&record)
        .iter()
        .for_each(|concern| warn(concern));
    if !arguments.quiet {
        let summary = report::summary(&record) + "\n";
        errors.extend(outputs.console().print(&summary).err());
    }
    match (errors.is_empty(), outcome.end == End::Interrupted) {
        (false, _) => Err(Failure::Files(errors)),
        (true, true) => Ok(Ending::Interrupted),
        (true, false) => Ok(Ending::Complete),
    }
}

fn develop(arguments: &RenderArguments, ready: &Ready) -> Result<(Best, Outcome), Failure> {
    let job = render::Job {
        aovs: &arguments.aov,
        kernel: arguments.kernel,
        until: arguments.until(),
        ..ready.job(&arguments.request()?)?
    };
    let best = arguments.best(&job);
    let stop = stop_flag();
    let mut display = Display::new(arguments.quiet);
    let outcome = render::render(&job, &best.target, &stop, &mut |progress| {
        display.update(progress)
    });
    display.finish();
    Ok((best, outcome.map_err(Failure::Render)?))
}

/// Writes pictures, what goes beside them and the JSON; notes in the record what was written and how long it took.
fn write(
    arguments: &RenderArguments,
    outputs: &Outputs,
    outcome: &Outcome,
    record: &mut Record,
) -> Vec<FileError> {
    let start = Instant::now();
    let [x0, y0, ..] = arguments.view.crop.unwrap_or_default();
    let (job, device) = (&record.job, &record.machine.device);
    let settings = arguments.settings.settings();
    let write = |files: &[Picture], film: &Film, notes: &[_]| {
        let frame = Frame {
            film,
            origin: [x0, y0],
            full: job.size,
        };
        let labels = Labels {
            exposure: arguments.exposure,
            software: SOFTWARE,
            notes,
        };
        write_frame(files, &frame, &labels)
    };
    let notes = report::notes(job, device);
    let (mut written, mut errors) = write(&outputs.pictures, &outcome.film, &notes);
    if let Some(stderr) = &outcome.stderr {
        let freedom = render::freedom(settings.estimator.sampler, job.spp);
        let notes = report::stderr_notes(freedom, &outcome.film, job, device);
        let (more, failed) = write(&outputs.stderr, stderr, &notes);
        written.extend(more);
        errors.extend(failed);
    } else if !outputs.stderr.is_empty() {
        warn("no standard errors are written: one sample tells nothing of its error");
    }
    record.files = written;
    record.seconds.write = start.elapsed().as_secs_f64();
    errors.extend(whole(outputs.json, || json(record)).err());
    errors
}

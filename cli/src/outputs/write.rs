//! Writing the results of a rendering or a merge.

use std::time::Instant;

use super::files::Outputs;
use super::pictures::Picture;
use vkpt::film::{Channel, Film};
use vkpt::image::file::FileError;
use vkpt::image::{Frame, Labels, encode};
use vkpt::part::AnyPart;
use vkpt::render::layer_samples;
use vkpt::report::{self, Denoised, Job, Record, SOFTWARE};
use vkpt::state::{self, Header};
use vkpt_lab::cli::destination::{Destination, json, whole};
use vkpt_lab::cli::exit::{Ending, Failure, warn};

/// Makes a denoised picture, or returns the reason for failure.
pub type Denoise<'a> = dyn Fn() -> Result<(Film, Denoised), String> + 'a;

/// The results to write.
pub struct Written<'a> {
    pub film: &'a Film,
    /// Layers of the EXRs.
    pub channels: &'a [Channel],
    /// Standard errors, with their degrees of freedom.
    pub stderr: Option<(&'a Film, f64)>,
    pub part: &'a AnyPart,
    /// The destinations of the part.
    pub parts: &'a [Destination],
    pub header: Header,
    /// Makes the denoised picture, after everything else is written.
    pub denoised: Option<&'a Denoise<'a>>,
}

/// Writes everything that can be written, so that one full disk does not lose hours of work; then prints warnings and the
/// summary.
pub fn write(outputs: &Outputs, of: Written) -> Result<Ending, Failure> {
    let start = Instant::now();
    let mut record = of.header.record.clone();
    let (mut files, mut errors) = pictures(outputs, &of, &record);
    for to in of.parts {
        match to.write(|out| state::write(out, &of.header, of.part)) {
            Ok(()) => files.push(to.to_string()),
            Err(error) => errors.push(error),
        }
    }
    record.files = files;
    record.seconds.write = start.elapsed().as_secs_f64();
    let lacks_denoised = match of.denoised.map(|denoise| denoise()) {
        None => false,
        Some(Ok((film, denoised))) => {
            let (files, failed) = denoised_pictures(outputs, &film, &denoised, &record);
            record.denoised = Some(Denoised { files, ..denoised });
            errors.extend(failed);
            false
        }
        Some(Err(why)) => {
            warn(&format!("no denoised picture was written: {why}"));
            true
        }
    };
    errors.extend(whole(&outputs.arguments.json, || json(&record)).err());
    report::concerns(&record)
        .iter()
        .for_each(|concern| warn(concern));
    if !outputs.arguments.quiet {
        let summary = report::summary(&record) + "\n";
        errors.extend(outputs.console().print(&summary).err());
    }
    match errors.is_empty() {
        false => Err(Failure::Files(errors)),
        true if record.job.ended == "interrupted" => Ok(Ending::Interrupted),
        true if lacks_denoised => Ok(Ending::Undenoised),
        true => Ok(Ending::Complete),
    }
}

/// Writes the pictures and the files next to them; returns the files written, and the errors.
fn pictures(outputs: &Outputs, of: &Written, record: &Record) -> (Vec<String>, Vec<FileError>) {
    let (job, device) = (&record.job, &record.machine.device);
    let [x0, y0, ..] = job.crop.unwrap_or_default();
    let write = |files: &[Picture], film: &Film, channels: &[Channel], notes: &[_]| {
        let frame = Frame {
            film,
            origin: [x0, y0],
            full: job.size,
            channels,
        };
        let labels = Labels {
            exposure: outputs.arguments.exposure,
            software: SOFTWARE,
            notes,
        };
        write_frame(files, &frame, &labels)
    };
    let notes = notes(job, device, of.channels);
    let (mut written, mut errors) = write(&outputs.pictures, of.film, of.channels, &notes);
    if let Some((stderr, freedom)) = of.stderr {
        let notes = report::stderr_notes(freedom, of.film, job, device);
        let (more, failed) = write(&outputs.stderr, stderr, &[], &notes);
        written.extend(more);
        errors.extend(failed);
    } else if !outputs.stderr.is_empty() {
        warn("no standard errors were written: a single sample has no standard error");
    }
    (written, errors)
}

/// The notes in a picture's header about it and its layers.
pub fn notes(job: &Job, device: &str, channels: &[Channel]) -> Vec<(&'static str, String)> {
    let mut notes = report::notes(job, device);
    if !channels.iter().all(Channel::is_light) {
        notes.push(report::layer_note(layer_samples(job.spp)));
    }
    if channels.iter().any(Channel::is_light) {
        notes.push(report::light_note(job));
    }
    notes
}

/// The denoised pictures, likewise.
fn denoised_pictures(
    outputs: &Outputs,
    film: &Film,
    denoised: &Denoised,
    record: &Record,
) -> (Vec<String>, Vec<FileError>) {
    let [x0, y0, ..] = record.job.crop.unwrap_or_default();
    let frame = Frame {
        film,
        origin: [x0, y0],
        full: record.job.size,
        channels: &[],
    };
    let labels = Labels {
        exposure: outputs.arguments.exposure,
        software: SOFTWARE,
        notes: &report::denoised_notes(denoised, &record.job, &record.machine.device),
    };
    write_frame(&outputs.denoised, &frame, &labels)
}

/// Writes the frame to every file that can be written.
fn write_frame(files: &[Picture], frame: &Frame, labels: &Labels) -> (Vec<String>, Vec<FileError>) {
    let (mut written, mut errors) = (Vec::new(), Vec::new());
    for Picture { to, format } in files {
        match to.write(|mut out| encode(frame, *format, labels, &mut out)) {
            Ok(()) => written.push(to.to_string()),
            Err(error) => errors.push(error),
        }
    }
    (written, errors)
}

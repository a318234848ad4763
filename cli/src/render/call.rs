//! A rendering for a calling program: pictures in memory, no files.

use std::io::Cursor;
use std::path::Path;

use super::arguments::RenderArguments;
use super::record::record;
use super::split::split;
use crate::outputs::notes;
use vkpt::film::{Channel, Film};
use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, encode};
use vkpt::render::{self, Best, Outcome, Progress, RenderError, Start, Watch};
use vkpt::report::{Record, SOFTWARE};
use vkpt_lab::cli::denoise::{denoised, load};
use vkpt_lab::cli::exit::{Failure, warn};
use vkpt_lab::cli::interrupt::stop_flag;
use vkpt_lab::cli::job::{Loaded, Ready};
use vkpt_lab::cli::progress::Display;

/// A picture, and everything that the command line would write next to it.
#[derive(Clone, Debug)]
pub struct Rendered {
    pub film: Film,
    /// Layers, and light by classes of paths.
    pub channels: Vec<Channel>,
    /// Standard errors of the mean.
    pub stderr: Option<Film>,
    /// Their degrees of freedom.
    pub freedom: f64,
    pub denoised: Option<Film>,
    pub record: Record,
}

/// Receives the growing picture; each snapshot is made only on request.
pub type Growing<'a> = dyn FnMut(&dyn Fn() -> Rendered) + 'a;

/// Renders as the arguments request; the flags of files and reports have no effect here. `None` if it was stopped before the
/// first sample was done.
pub fn rendered(
    arguments: &RenderArguments,
    growing: &mut Growing,
) -> Result<Option<Rendered>, Failure> {
    arguments.check_denoise()?;
    let denoiser = arguments
        .denoise
        .denoise
        .map(|by| load(arguments.denoise.oidn.as_deref(), by).map_err(Failure::Usage))
        .transpose()?;
    let request = arguments.request()?;
    let ready = Loaded::new(&request)?.prepare(&request)?;
    let asked = arguments.beside();
    let job = arguments.job(&ready, &asked)?;
    let call = Call {
        arguments,
        ready: &ready,
        best: &arguments.best(&job),
    };
    let stop = stop_flag();
    let mut watcher = Watcher {
        display: Display::new(arguments.outputs.quiet),
        call: &call,
        growing,
    };
    let start = Start::At(arguments.range().start);
    let outcome = arguments.develop(&job, &call.best.target, &start, &stop, &mut watcher);
    watcher.display.finish();
    let mut outcome = outcome.map_err(Failure::Render)?;
    if let Some(why) = outcome.failure {
        return Err(Failure::Lost { why, part: None });
    }
    if outcome.spp == 0 {
        return Ok(None);
    }
    let mut channels = render::layers(&job, outcome.spp);
    channels.extend(split(&job, &mut outcome, &stop, arguments.outputs.quiet));
    let mut rendered = Rendered {
        channels,
        ..call.rendered(&outcome)
    };
    if let Some(denoiser) = denoiser {
        rendered.denoise(denoised(&denoiser, &job, &outcome));
    }
    Ok(Some(rendered))
}

impl Rendered {
    /// The file that the command line would write, byte for byte; PNGs are brightened by `exposure` stops.
    pub fn encode(&self, format: Format, exposure: f64) -> Result<Vec<u8>, Failure> {
        let job = &self.record.job;
        let [x0, y0, ..] = job.crop.unwrap_or_default();
        let frame = Frame {
            film: &self.film,
            origin: [x0, y0],
            full: job.size,
            channels: &self.channels,
        };
        let labels = Labels {
            exposure,
            software: SOFTWARE,
            notes: &notes(job, &self.record.machine.device, &self.channels),
        };
        let mut bytes = Cursor::new(Vec::new());
        let encoded = encode(&frame, format, &labels, &mut bytes);
        encoded.map_err(|error| Failure::Pictures(vec![error.to_string()]))?;
        Ok(bytes.into_inner())
    }

    /// Writes that file, whole or not at all, in the format of its name.
    pub fn save(&self, path: &Path, exposure: f64) -> Result<(), Failure> {
        let Some(format) = Format::of(path) else {
            return Err(Failure::Usage(format!(
                "{}: the ending must be .png, .hdr or .exr",
                path.display()
            )));
        };
        let bytes = self.encode(format, exposure)?;
        let written = write_whole(path, |out| out.write_all(&bytes));
        written.map_err(|error| Failure::Files(vec![error]))
    }

    fn denoise(&mut self, made: Result<(Film, vkpt::report::Denoised), String>) {
        match made {
            Ok((film, record)) => {
                self.denoised = Some(film);
                self.record.denoised = Some(record);
            }
            Err(why) => warn(&format!("no denoised picture was made: {why}")),
        }
    }
}

/// The sources of a record.
struct Call<'a> {
    arguments: &'a RenderArguments,
    ready: &'a Ready,
    best: &'a Best,
}

impl Call<'_> {
    /// The picture without its layers.
    fn rendered(&self, outcome: &Outcome) -> Rendered {
        Rendered {
            film: outcome.film.clone(),
            channels: Vec::new(),
            stderr: outcome.stderr.clone(),
            freedom: outcome.state.part.freedom(),
            denoised: None,
            record: record(self.arguments, self.ready, self.best, Some(outcome)),
        }
    }
}

/// Shows the caller the progress of the rendering.
struct Watcher<'a, 'b> {
    display: Display,
    call: &'a Call<'a>,
    growing: &'a mut Growing<'b>,
}

impl Watch for Watcher<'_, '_> {
    fn progress(&mut self, progress: Progress) {
        self.display.update(progress);
    }

    fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        (self.growing)(&|| self.call.rendered(&so_far()));
    }

    fn lost(&mut self, error: &RenderError, then: &str) {
        warn(&format!("the device failed: {error}; {then}"));
    }
}

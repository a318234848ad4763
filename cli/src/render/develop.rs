//! Rendering, with a display and checkpoints.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::arguments::RenderArguments;
use super::record::{error_of, record};
use super::split::split;
use crate::keep::{Checkpoint, hint, resumed};
use crate::live::Viewers;
use vkpt::film::Channel;
use vkpt::render::{self, Best, Job, NEAREST, Outcome, Progress, RenderError, Start, State, Watch};
use vkpt::report::Record;
use vkpt::state::{Header, Kept};
use vkpt_lab::cli::exit::{Failure, note, warn};
use vkpt_lab::cli::job::Ready;
use vkpt_lab::cli::progress::Display;

/// The purpose of a rendering.
pub struct Goal<'a> {
    /// The file of the part.
    pub kept: Option<&'a Path>,
    /// Of the scene and its meshes.
    pub digest: String,
    /// Whether pictures are wanted, not only the part.
    pub pictures: bool,
}

/// The result.
pub struct Made {
    pub outcome: Outcome,
    /// Layers.
    pub channels: Vec<Channel>,
    pub header: Header,
    /// Degrees of freedom of its standard errors.
    pub freedom: f64,
    /// Whether a part is on disk that must be kept up to date.
    pub checkpointed: bool,
}

/// Renders to the requested end; `None` if only the part is requested and it is already complete.
pub fn develop(
    arguments: &RenderArguments,
    ready: &Ready,
    job: &Job,
    goal: Goal,
    stop: &AtomicBool,
    viewers: &mut Viewers,
) -> Result<Option<Made>, Failure> {
    let best = arguments.best(job);
    let labels = Labels {
        arguments,
        ready,
        best: &best,
        digest: goal.digest,
        earlier: None,
    };
    let (labels, start) = begin(labels, job, goal.kept)?;
    if start.range().end == job.spp && !goal.pictures {
        note("nothing to do: the file already contains all samples");
        return Ok(None);
    }
    let pause = arguments.pause().zip(goal.kept);
    let resumes = matches!(start, Start::After(_));
    let mut watcher = Watcher {
        display: Display::new(arguments.outputs.quiet),
        checkpoint: pause.map(|(pause, path)| Checkpoint::new(path.to_owned(), pause, resumes)),
        labels: &labels,
        viewers,
    };
    let outcome = arguments.develop(job, &best.target, &start, stop, &mut watcher);
    watcher.display.finish();
    let checkpointed = watcher.checkpoint.map_or(resumes, |c| c.written);
    let mut outcome = outcome.map_err(Failure::Render)?;
    watcher.viewers.rendered(&outcome);
    let mut channels = render::layers(job, outcome.spp);
    channels.extend(split(job, &mut outcome, stop, arguments.outputs.quiet));
    let header = labels.header(&outcome);
    Ok(Some(Made {
        freedom: outcome.state.part.freedom(),
        header,
        channels,
        outcome,
        checkpointed,
    }))
}

/// Where the rendering starts: after the part on disk, if requested.
fn begin<'a>(
    mut labels: Labels<'a>,
    job: &Job,
    kept: Option<&Path>,
) -> Result<(Labels<'a>, Start), Failure> {
    let arguments = labels.arguments;
    let samples = arguments.range();
    let anew = Start::At(samples.start);
    let Some(path) = kept else {
        return Ok((labels, anew));
    };
    let own = labels.header_of(record(arguments, labels.ready, labels.best, None), NEAREST);
    if !arguments.resume {
        if !arguments.outputs.quiet {
            hint(path, &own, samples);
        }
        return Ok((labels, anew));
    }
    let keeps = job.features().keeps();
    let target = &labels.best.target;
    let Some(Kept { header, part }) = resumed(path, &own, samples, target, keeps)? else {
        return Ok((labels, anew));
    };
    labels.earlier = Some(header.rounding);
    let Record { error, seconds, .. } = header.record;
    let state = State {
        part,
        errors: error.iter().map(error_of).collect(),
        seconds: seconds.render,
    };
    Ok((labels, Start::After(state)))
}

/// The data written with the samples.
struct Labels<'a> {
    arguments: &'a RenderArguments,
    ready: &'a Ready,
    best: &'a Best,
    digest: String,
    /// How the device that made the earlier samples rounds.
    earlier: Option<String>,
}

impl Labels<'_> {
    fn header(&self, outcome: &Outcome) -> Header {
        let record = record(self.arguments, self.ready, self.best, Some(outcome));
        self.header_of(record, &outcome.stats.rounding)
    }

    fn header_of(&self, record: Record, rounding: &str) -> Header {
        let rounding = match &self.earlier {
            Some(earlier) if earlier != rounding => format!("{earlier}, then {rounding}"),
            _ => rounding.to_owned(),
        };
        Header {
            digest: self.digest.clone(),
            rounding,
            record,
        }
    }
}

/// Shows progress and writes checkpoints.
struct Watcher<'a> {
    display: Display,
    checkpoint: Option<Checkpoint>,
    labels: &'a Labels<'a>,
    viewers: &'a mut Viewers,
}

impl Watch for Watcher<'_> {
    fn progress(&mut self, progress: Progress) {
        self.display.update(progress);
        self.viewers.progress(progress);
    }

    fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        if let Some(checkpoint) = self.checkpoint.as_mut().filter(|c| c.is_due()) {
            checkpoint.write(|| {
                let outcome = so_far();
                (self.labels.header(&outcome), outcome.state.part)
            });
        }
        self.viewers.reached(so_far);
    }

    fn lost(&mut self, error: &RenderError, then: &str) {
        let words = format!("the device failed: {error}; {then}");
        warn(&words);
        self.viewers.trouble(&words);
    }
}

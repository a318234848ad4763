//! The state of the rendering for a tab, as JSON.

use serde::Serialize;

use super::snapshot::Snapshot;
use vkpt::render::ErrorAt;

/// The phase of a rendering.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
    /// Samples are rendered.
    Rendering,
    /// All samples are done; files are written.
    Writing,
    /// The files are written, and nothing more will come.
    Ended,
    /// Not all files are written; the terminal shows why.
    Failed,
}

impl Phase {
    /// Whether nothing more will come.
    pub fn is_last(self) -> bool {
        matches!(self, Self::Ended | Self::Failed)
    }
}

/// The state at one moment.
#[derive(Debug, Serialize)]
pub struct State {
    /// A number that differs between renderings.
    pub run: u32,
    pub phase: Phase,
    /// Somebody has stopped it early.
    pub stopping: bool,
    /// Samples in every pixel.
    pub samples: u32,
    /// The maximum; `None` if only time or error end it.
    pub spp: Option<u32>,
    /// The fraction of the work done, in [0, 1].
    pub fraction: f64,
    /// Since the rendering started, including compiling.
    pub seconds: f64,
    pub seconds_left: Option<f64>,
    /// A message about failed devices.
    pub trouble: Option<String>,
    pub picture: Option<PictureState>,
    pub errors: Vec<ErrorState>,
}

/// The newest snapshot.
#[derive(Debug, Serialize)]
pub struct PictureState {
    number: u64,
    width: u32,
    height: u32,
    /// Column and row of the first pixel in the full picture.
    origin: [u32; 2],
    samples: u32,
}

/// The error at one time: an estimate of relMSE, and its 95 % interval, if any.
#[derive(Debug, Serialize)]
pub struct ErrorState {
    spp: u32,
    seconds: f64,
    estimate: f64,
    interval: Option<[f64; 2]>,
}

impl PictureState {
    pub fn of(snapshot: &Snapshot) -> Self {
        let film = &snapshot.film;
        Self {
            number: snapshot.number,
            width: film.width,
            height: film.height,
            origin: snapshot.origin,
            samples: snapshot.samples,
        }
    }
}

impl ErrorState {
    /// `None` if the error is unknown.
    pub fn of(error: &ErrorAt) -> Option<Self> {
        let rel_mse = error.rel_mse?;
        Some(Self {
            spp: error.spp,
            seconds: error.seconds,
            estimate: rel_mse.estimate,
            interval: rel_mse.interval.ok(),
        })
    }
}

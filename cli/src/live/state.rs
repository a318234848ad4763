//! What a tab is told of the rendering, as JSON.

use serde::Serialize;

use super::snapshot::Snapshot;
use vkpt::render::ErrorAt;

/// How far a rendering is on its way to files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
    /// Samples are made.
    Rendering,
    /// All samples are there; files are made.
    Writing,
    /// The files are written, and nothing more will come.
    Ended,
    /// Not all files are; the terminal says why.
    Failed,
}

impl Phase {
    /// Whether nothing more will come.
    pub fn is_last(self) -> bool {
        matches!(self, Self::Ended | Self::Failed)
    }
}

/// All that can be told at one moment.
#[derive(Debug, Serialize)]
pub struct State {
    /// Of another rendering it is another number.
    pub run: u32,
    pub phase: Phase,
    /// Somebody has asked it to end early.
    pub stopping: bool,
    /// Samples that every pixel has.
    pub samples: u32,
    /// The most that it will have; `None` where time or error are to end it alone.
    pub spp: Option<u32>,
    /// Of all work, in [0, 1].
    pub fraction: f64,
    /// Since the rendering began, compiling included.
    pub seconds: f64,
    pub seconds_left: Option<f64>,
    /// What became of devices.
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

/// The error at one time: an estimate of relMSE, and its 95 % interval where there is one.
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
    /// `None` where nothing is known of the error.
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

//! The arrays that a rendering writes, an element a thread; they depend on the integrator.

use super::array::ArrayPlan;
use crate::features::{Features, Keeps};
use crate::kernel::scene::{Recording, SPLATS};
use crate::layout::constants::bidirectional::KEPT;
use crate::layout::{
    BufferUse, EyeState, FilmMoments, FilmPixel, FilmQuarters, GpuStruct, LightLane, LightSlice,
    LightState, LightVertex, PathOutcome, PathState, Radiance, Record, Reservoir, Slice, Splat,
};
use crate::part::PixelSums;
use crate::render::tiles::{Tile, tiles};
use crate::render::{Job, LightFilm};
use crate::settings::Integrator;

/// The most light paths in flight at once: each thread has its slots for splats.
const LIGHT_PATHS: u32 = 1 << 16;

/// Light paths whose vertices are kept at once: threads of smaller tiles keep those of several samples.
const KEPT_PATHS: u32 = 1 << 18;

/// The arrays of a tile's threads between two dispatches, and their results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatePlan {
    Path(PathPlan),
    Light(LightPlan),
    Bidirectional(LightPlan, EyePlan),
}

/// Paths and film of a tile, and their additional sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathPlan {
    pub paths: ArrayPlan,
    pub film: ArrayPlan,
    /// The additional sums of each pixel.
    pub beside: Option<ArrayPlan>,
    /// Events of one path, or outcomes of all.
    pub recorded: Option<ArrayPlan>,
}

/// Light paths of a tile, and their splats. The film is the host's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightPlan {
    pub paths: ArrayPlan,
    pub lanes: ArrayPlan,
    pub splats: ArrayPlan,
}

/// Eye paths of a tile, their contributions, and the vertices that they are joined to: for each thread and several samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EyePlan {
    pub paths: ArrayPlan,
    pub radiances: ArrayPlan,
    pub vertices: ArrayPlan,
    pub reservoirs: ArrayPlan,
}

impl StatePlan {
    /// Room for tiles of `threads` threads.
    pub fn new(features: &Features, threads: u32, recording: Recording) -> Self {
        match features.integrator {
            Integrator::Path => Self::Path(PathPlan::new(features, threads, recording)),
            Integrator::Light => Self::Light(LightPlan::new(threads)),
            Integrator::Bidirectional => {
                Self::Bidirectional(LightPlan::new(threads), EyePlan::new(threads))
            }
        }
    }

    /// In the order of their bindings, which follow the scene's.
    pub fn plans(&self) -> Vec<ArrayPlan> {
        match self {
            Self::Path(p) => p.plans().collect(),
            Self::Light(p) => p.plans().collect(),
            Self::Bidirectional(light, eye) => light.plans().chain(eye.plans()).collect(),
        }
    }

    /// How many of them each kernel has, in the order of their dispatches.
    pub fn bound(&self) -> Vec<usize> {
        match self {
            Self::Path(p) => vec![p.plans().count()],
            Self::Light(p) => vec![p.plans().count()],
            // Light paths write the vertices that eye paths read; both have lanes.
            Self::Bidirectional(light, eye) => {
                vec![light.plans().count() + 2, eye.plans().count() + 1]
            }
        }
    }

    /// Bytes of a dispatch's push constants.
    pub fn push_bytes(&self) -> usize {
        match self {
            Self::Path(_) => size_of::<Slice>(),
            Self::Light(_) | Self::Bidirectional(..) => size_of::<LightSlice>(),
        }
    }

    /// Bytes that the host stores for each pixel of the picture.
    pub fn film_bytes(&self, features: &Features) -> u64 {
        let beside = match features.keeps() {
            Keeps::Nothing => 0,
            Keeps::Moments => size_of::<FilmMoments>() as u64,
            Keeps::Quarters => size_of::<FilmQuarters>() as u64,
        };
        beside
            + match self {
                Self::Path(_) => size_of::<PixelSums<f32>>() as u64,
                Self::Light(_) | Self::Bidirectional(..) => LightFilm::<f32>::PIXEL_BYTES,
            }
    }
}

impl PathPlan {
    pub fn new(features: &Features, pixels: u32, recording: Recording) -> Self {
        let pixels = pixels as usize;
        Self {
            paths: storage::<PathState>("paths", pixels),
            film: storage::<FilmPixel>("film", pixels),
            beside: match features.keeps() {
                Keeps::Nothing => None,
                Keeps::Moments => Some(storage::<FilmMoments>("moments", pixels)),
                Keeps::Quarters => Some(storage::<FilmQuarters>("quarters", pixels)),
            },
            recorded: match recording {
                Recording::Nothing => None,
                Recording::Events(n) => Some(storage::<Record>("records", n as usize)),
                Recording::Outcomes(n) => {
                    Some(storage::<PathOutcome>("outcomes", n as usize * pixels))
                }
            },
        }
    }

    pub fn plans(&self) -> impl Iterator<Item = ArrayPlan> {
        [self.paths, self.film]
            .into_iter()
            .chain(self.beside)
            .chain(self.recorded)
    }
}

impl LightPlan {
    pub fn new(threads: u32) -> Self {
        let threads = threads as usize;
        Self {
            paths: storage::<LightState>("light_paths", threads),
            lanes: storage::<LightLane>("lanes", threads),
            splats: storage::<Splat>("splats", threads * SPLATS as usize),
        }
    }

    pub fn plans(&self) -> impl Iterator<Item = ArrayPlan> {
        [self.paths, self.lanes, self.splats].into_iter()
    }
}

impl EyePlan {
    pub fn new(threads: u32) -> Self {
        let samples = (threads * Self::samples(threads)) as usize;
        Self {
            paths: storage::<EyeState>("eye_paths", threads as usize),
            radiances: storage::<Radiance>("radiances", samples),
            vertices: storage::<LightVertex>("light_vertices", samples * KEPT as usize),
            reservoirs: storage::<Reservoir>("reservoirs", samples),
        }
    }

    /// The number of samples of a thread that fit.
    pub fn samples(threads: u32) -> u32 {
        (KEPT_PATHS / threads.max(1)).max(1)
    }

    pub fn plans(&self) -> impl Iterator<Item = ArrayPlan> {
        [self.paths, self.radiances, self.vertices, self.reservoirs].into_iter()
    }
}

fn storage<T: GpuStruct>(name: &'static str, count: usize) -> ArrayPlan {
    ArrayPlan::records::<T>(name, count, BufferUse::Storage)
}

/// Tiles of at most `most` threads, one after the other: pixels of the picture or of its crop; for a light tracer,
/// whose paths contribute to any pixel, all of the picture.
pub fn thread_tiles(job: &Job, most: u32) -> Vec<Tile> {
    match job.settings.estimator.integrator {
        Integrator::Path => tiles(job.area(), most.max(1)),
        Integrator::Light | Integrator::Bidirectional => {
            tiles(job.whole(), most.clamp(1, LIGHT_PATHS))
        }
    }
}

//! The arrays that a rendering writes: an element a pixel of the tile under way.

use super::array::ArrayPlan;
use crate::features::Features;
use crate::kernel::scene::Recording;
use crate::layout::{BufferUse, FilmMoments, FilmPixel, GpuStruct, PathOutcome, PathState, Record};

/// Paths and film of a tile, and what else is kept of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StatePlan {
    pub paths: ArrayPlan,
    pub film: ArrayPlan,
    /// Where standard errors are asked for.
    pub moments: Option<ArrayPlan>,
    /// Events of one path, or outcomes of all.
    pub recorded: Option<ArrayPlan>,
}

impl StatePlan {
    /// Room for tiles of `pixels` pixels.
    pub fn new(features: &Features, pixels: u32, recording: Recording) -> Self {
        let pixels = pixels as usize;
        Self {
            paths: storage::<PathState>("paths", pixels),
            film: storage::<FilmPixel>("film", pixels),
            moments: features
                .keeps_moments()
                .then(|| storage::<FilmMoments>("moments", pixels)),
            recorded: match recording {
                Recording::Nothing => None,
                Recording::Events(n) => Some(storage::<Record>("records", n as usize)),
                Recording::Outcomes(n) => {
                    Some(storage::<PathOutcome>("outcomes", n as usize * pixels))
                }
            },
        }
    }

    /// In the order of their bindings, which follow the scene's.
    pub fn plans(&self) -> impl Iterator<Item = ArrayPlan> {
        [self.paths, self.film]
            .into_iter()
            .chain(self.moments)
            .chain(self.recorded)
    }
}

fn storage<T: GpuStruct>(name: &'static str, count: usize) -> ArrayPlan {
    ArrayPlan::records::<T>(name, count, BufferUse::Storage)
}

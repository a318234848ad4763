//! What is an integrator's own in a kernel: the root file, the arrays that it writes, what a dispatch is told.

use super::Recording;
use crate::features::Features;
use crate::layout::{
    FilmMoments, FilmPixel, GpuStruct, LightLane, LightSlice, LightState, PathOutcome, PathState,
    Record, Slice, Splat,
};
use crate::settings::Integrator;

/// An array that a kernel writes, a record's name and text.
pub struct StateArray {
    pub ty: &'static str,
    pub name: &'static str,
    pub glsl: String,
}

/// The parts of a kernel that are its integrator's.
pub struct Own {
    pub root: &'static str,
    /// In the order of their bindings, which follow the scene's.
    pub state: Vec<StateArray>,
    /// The push constants: a record's name and text.
    pub slice: (&'static str, String),
}

impl Own {
    pub fn of(features: &Features, recording: Recording) -> Self {
        match features.integrator {
            Integrator::Path | Integrator::Bidirectional => Self {
                root: "integrator/path/path_trace.comp",
                state: path_state(features, recording),
                slice: (Slice::NAME, Slice::glsl()),
            },
            Integrator::Light => Self {
                root: "integrator/light/light_trace.comp",
                state: vec![
                    array::<LightState>("light_paths"),
                    array::<LightLane>("lanes"),
                    array::<Splat>("splats"),
                ],
                slice: (LightSlice::NAME, LightSlice::glsl()),
            },
        }
    }
}

fn path_state(features: &Features, recording: Recording) -> Vec<StateArray> {
    let mut state = vec![array::<PathState>("paths"), array::<FilmPixel>("film")];
    if features.keeps_moments() {
        state.push(array::<FilmMoments>("moments"));
    }
    match recording {
        Recording::Nothing => {}
        Recording::Events(_) => state.push(array::<Record>("records")),
        Recording::Outcomes(_) => state.push(array::<PathOutcome>("outcomes")),
    }
    state
}

fn array<T: GpuStruct>(name: &'static str) -> StateArray {
    StateArray {
        ty: T::NAME,
        name,
        glsl: T::glsl(),
    }
}

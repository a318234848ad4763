//! The parts of a kernel that belong to its integrator: the root file, the arrays that it writes, the push constants.

use super::{Recording, Side};
use crate::features::{Features, Keeps};
use crate::layout::{
    EyeState, FilmMoments, FilmPixel, FilmQuarters, GpuStruct, LightLane, LightSlice, LightState,
    LightVertex, PathOutcome, PathState, Radiance, Record, Reservoir, Slice, Splat,
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
    pub fn of(features: &Features, recording: Recording, side: Side) -> Self {
        match (features.integrator, side) {
            (Integrator::Path, _) => Self {
                root: "integrator/path/path_trace.comp",
                state: path_state(features, recording),
                slice: (Slice::NAME, Slice::glsl()),
            },
            (Integrator::Light, _) => Self::light(light_state()),
            (Integrator::Bidirectional, Side::Light) => {
                let mut state = light_state();
                state.extend(kept_state());
                Self::light(state)
            }
            (Integrator::Bidirectional, Side::Eye) => Self {
                root: "integrator/bidirectional/eye_trace.comp",
                state: eye_state(),
                slice: (LightSlice::NAME, LightSlice::glsl()),
            },
        }
    }

    fn light(state: Vec<StateArray>) -> Self {
        Self {
            root: "integrator/light/light_trace.comp",
            state,
            slice: (LightSlice::NAME, LightSlice::glsl()),
        }
    }
}

fn light_state() -> Vec<StateArray> {
    vec![
        array::<LightState>("light_paths"),
        array::<LightLane>("lanes"),
        array::<Splat>("splats"),
    ]
}

/// The arrays that light paths fill for eye paths.
fn kept_state() -> [StateArray; 2] {
    [
        array::<LightVertex>("light_vertices"),
        array::<Reservoir>("reservoirs"),
    ]
}

fn eye_state() -> Vec<StateArray> {
    let [vertices, reservoirs] = kept_state();
    vec![
        array::<EyeState>("eye_paths"),
        array::<LightLane>("lanes"),
        array::<Radiance>("radiances"),
        vertices,
        reservoirs,
    ]
}

fn path_state(features: &Features, recording: Recording) -> Vec<StateArray> {
    let mut state = vec![array::<PathState>("paths"), array::<FilmPixel>("film")];
    match features.keeps() {
        Keeps::Nothing => {}
        Keeps::Moments => state.push(array::<FilmMoments>("moments")),
        Keeps::Quarters => state.push(array::<FilmQuarters>("quarters")),
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

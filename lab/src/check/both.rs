//! The battery rendered with bidirectional paths.

use super::case::{Case, Expectation, Stiffness};
use vkpt::settings::{Absorption, Connect, Integrator, Settings};

/// Paths of a sample: its contribution may involve the vertices of both.
const PATHS: f64 = 2.0;
/// Decisions at a vertex relative to a path tracer: two connections in addition to shape, light, lobe and roulette.
const DECISIONS: f64 = 6.0 / 4.0;

/// The cases that bidirectional paths can render, with bounds that apply to them.
pub fn bidirectional(battery: Vec<Case>) -> Vec<Case> {
    battery.into_iter().filter_map(of_both_ends).collect()
}

/// These settings with paths from both ends; `None` if the settings do not allow it.
pub fn both_ends(mut settings: Settings) -> Option<Settings> {
    let weighs = settings.estimator.connect == Connect::Mis;
    let along = settings.model.absorption == Absorption::Segment;
    settings.estimator.integrator = Integrator::Bidirectional;
    (weighs && along).then_some(settings)
}

fn of_both_ends(mut case: Case) -> Option<Case> {
    case.settings = both_ends(case.settings)?;
    let Stiffness {
        vertices,
        decisions,
        light,
        why,
    } = case.stiffness;
    let why = format!("{why}; two paths per sample, and two more connections per vertex");
    case.stiffness = Stiffness::new(PATHS * vertices, DECISIONS * decisions, light, why);
    // The weight of a light path's splat depends on the size of its pixel: the model does not bound it.
    case.weight = None;
    let cropped = case.crop.is_some();
    case.expectations
        .retain(|expected| !(cropped && is_of_pixels(expected)));
    Some(case)
}

/// Whether the expectation concerns only some pixels: splats of their samples go to others.
fn is_of_pixels(expected: &Expectation) -> bool {
    match expected {
        Expectation::Mean { .. } | Expectation::AtMost { .. } | Expectation::SameMean { .. } => {
            true
        }
        Expectation::SameBits { .. } | Expectation::Warning(_) => false,
    }
}

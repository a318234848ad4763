//! The battery by bidirectional paths.

use super::case::{Case, Expectation, Stiffness};
use vkpt::settings::{Absorption, Connect, Integrator, Settings};

/// Paths of a sample: what one brings may have come over the vertices of both.
const PATHS: f64 = 2.0;
/// Decisions at a vertex over those of a path tracer: two more connections, beside shape, light, lobe and roulette.
const DECISIONS: f64 = 6.0 / 4.0;

/// The cases that bidirectional paths can render, with bounds that hold for them.
pub fn bidirectional(battery: Vec<Case>) -> Vec<Case> {
    battery.into_iter().filter_map(of_both_ends).collect()
}

/// These settings with paths from both ends; `None` where these cannot be had.
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
    let why = format!("{why}; two paths a sample, and two connections more a vertex");
    case.stiffness = Stiffness::new(PATHS * vertices, DECISIONS * decisions, light, why);
    // A light path's splat has the weight that its pixel, a part of the picture, gives it: no bound of the model's.
    case.weight = None;
    let cropped = case.crop.is_some();
    case.expectations
        .retain(|expected| !(cropped && is_of_pixels(expected)));
    Some(case)
}

/// Whether what is expected is that of some pixels: splats of their samples go to others.
fn is_of_pixels(expected: &Expectation) -> bool {
    match expected {
        Expectation::Mean { .. } | Expectation::AtMost { .. } | Expectation::SameMean { .. } => {
            true
        }
        Expectation::SameBits { .. } | Expectation::Warning(_) => false,
    }
}

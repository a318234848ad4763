//! The battery of stiff and extreme cases with bidirectional paths: no sample is lost, and the mean is the closed form's, or that of
//! paths from the eye.

use vkpt::film::Film;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{Job, Outcome, Target};
use vkpt::settings::Settings;
use vkpt_lab::check::both::both_ends;
use vkpt_lab::check::{Case, Expectation, battery};

use crate::common::render::{job, outcome};
use crate::common::stats::{p_of_difference, p_of_mean, sidak};

const ALPHA: f64 = 1e-3;
const SEEDS: u32 = 8;
/// Pixels of a picture that is rendered whole.
const LARGEST: u32 = 1 << 16;
/// Two means in f32 may differ by their rounding.
const ROUNDING: f64 = 1e-5;
/// Values for which f32 has no normal number.
const LEAST: f64 = f32::MIN_POSITIVE as f64;

fn mean(film: &Film) -> f64 {
    let sum: f64 = film.rgb.iter().flatten().map(|&x| f64::from(x)).sum();
    sum / (3 * film.rgb.len()) as f64
}

fn rendered(case: &Case, prepared: &Prepared, settings: Settings, seed: u32) -> Outcome {
    let job = Job {
        crop: case.crop,
        ..job(prepared, settings, case.spp, seed)
    };
    outcome(&job, &Target::CpuF32)
}

fn means(case: &Case, prepared: &Prepared, settings: Settings, first: u32) -> Vec<f64> {
    let of = |seed| mean(&rendered(case, prepared, settings, seed).film);
    (first..first + SEEDS).map(of).collect()
}

/// The errors of a case, if any.
fn complaint(case: &Case, settings: Settings, level: f64) -> Option<String> {
    let (scene, _) = case.scene().expect("a scene");
    let prepared = prepare(&scene, &settings, None).expect("a scene");
    // With any crop, the light paths of all pixels are followed.
    if prepared.camera.width * prepared.camera.height > LARGEST {
        return None;
    }
    let first = rendered(case, &prepared, settings, 1);
    let dropped = first.stats.dropped;
    if dropped.nan + dropped.infinite > 0 {
        return Some(format!("{}: {dropped:?}", case.name));
    }
    let found = means(case, &prepared, settings, 1);
    let closed = case.expectations.iter().find_map(|e| match e {
        Expectation::Mean { value, .. } => Some(*value),
        _ => None,
    });
    let p = match closed {
        Some(value) => p_of_mean(&found, value, ROUNDING * value + LEAST),
        None => {
            let of_paths = means(case, &prepared, case.settings, 101);
            let off = (found.iter().sum::<f64>() - of_paths.iter().sum::<f64>()).abs();
            let least = ROUNDING * of_paths.iter().sum::<f64>();
            if off <= least {
                1.0
            } else {
                p_of_difference(&of_paths, &found)
            }
        }
    };
    (p <= level).then(|| format!("{}: p = {p:.1e}, {closed:?} for {found:?}", case.name))
}

#[test]
fn every_case_has_the_mean_of_its_closed_form_or_of_paths() {
    let all = battery();
    let cases: Vec<_> = (all.iter())
        .filter(|case| !case.slow)
        .filter_map(|case| Some((case, both_ends(case.settings)?)))
        .collect();
    assert!(cases.len() > 80, "{}", cases.len());
    let level = sidak(ALPHA, cases.len());
    let bad: Vec<String> = (cases.iter())
        .filter_map(|(case, settings)| complaint(case, *settings, level))
        .collect();
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

//! Scenes in other programs' words.

mod gltf;
mod mitsuba;
mod pbrt;
mod scenes;

use std::path::Path;

use vkpt::prepared::prepare;
use vkpt::settings::{Absorption, Model, Settings};
use vkpt_cli::export::{Export, Remark, Subject};

/// The export by `by` of a text's scene.
fn exported<E>(
    text: &str,
    settings: &Settings,
    by: impl Fn(&Subject) -> Result<Export, E>,
) -> Result<Export, E> {
    let read = vkpt::scene::parse(text, Path::new("scene.scn"), false).expect("a scene");
    let prepared = prepare(&read.scene, settings, None).expect("a scene that can be prepared");
    by(&Subject {
        scene: &read.scene,
        prepared: &prepared,
        model: &settings.model,
        crop: None,
        stem: "a & b",
    })
}

/// Each refused line and why; something must be.
fn refusals<E, R>(exported: Result<E, Vec<Remark<R>>>) -> Vec<(usize, R)> {
    let refusals = exported.err().expect("something is refused").into_iter();
    refusals.map(|r| (r.line, r.reason)).collect()
}

/// Models that no other program has, and the flag that each is named by.
fn models_without_an_equal() -> [(Model, &'static str); 2] {
    let default = Settings::default().model;
    let term = Model {
        absorption: Absorption::Term,
        ..default
    };
    let unscaled = Model {
        radiance_scaling: false,
        ..default
    };
    [
        (term, "--absorption term"),
        (unscaled, "--radiance-scaling off"),
    ]
}

/// All that an export writes as the scene.
fn written(export: &Export) -> Vec<u8> {
    let mut bytes = Vec::new();
    export.write(&mut bytes).expect("memory takes it");
    bytes
}

fn same(given: &[f64], expected: &[f64], what: &str) {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-14 * b.abs().max(1.0);
    let equal = given.len() == expected.len() && given.iter().zip(expected).all(close);
    assert!(equal, "{what}: {given:?} instead of {expected:?}");
}

//! Scenes in other programs' words.

mod gltf;
mod mitsuba;
mod pbrt;
mod scenes;

use std::path::Path;

use vkpt::export::{Export, Subject};
use vkpt::prepared::prepare;
use vkpt::settings::Settings;

/// What `by` makes of the scene that a text holds.
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

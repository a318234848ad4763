//! glTF files as scenes.

use std::path::Path;

use miette::Severity;
use vkpt::scene::{Errors, Read, parse_model};

use super::scene::{is_drawn, promises_kept};

/// A scene that keeps its promises, or errors; with `strict` errors for warnings. It has no external buffers.
pub fn model(bytes: &[u8]) {
    let path = Path::new("none/scene.glb");
    let [read, strict] = [false, true].map(|strict| parse_model(bytes, path, strict, None));
    let diagnostics = match &read {
        Ok(Read { warnings, .. }) => warnings,
        Err(Errors { diagnostics, .. }) => diagnostics,
    };
    let any = |severity| diagnostics.iter().any(|d| d.severity == severity);
    assert_eq!(any(Severity::Error), read.is_err(), "errors");
    let clean = read.is_ok() && !any(Severity::Warning);
    assert_eq!(strict.is_ok(), clean, "--strict");
    for diagnostic in diagnostics {
        super::has_message(diagnostic);
        assert!(diagnostic.place.is_none(), "the file has no such line");
    }
    if let Some(first) = diagnostics.first() {
        is_drawn(first);
    }
    if let Ok(read) = read {
        is_listed(&read);
        promises_kept(&read.scene);
        super::prepared::is_prepared(&read.scene);
    }
}

/// Materials, shapes and the camera have lines in the listing, each its own.
fn is_listed(read: &Read) {
    let scene = &read.scene;
    let materials = scene.materials.iter().map(|m| m.line);
    let shapes = scene.shapes.iter().map(|s| s.line);
    let mut lines: Vec<usize> = materials.chain(shapes).chain([scene.camera_line]).collect();
    let all = lines.len();
    lines.sort_unstable();
    lines.dedup();
    assert_eq!(lines.len(), all, "lines that two things share");
    let there = 1..=read.text.lines().count();
    assert!(lines.iter().all(|line| there.contains(line)), "{lines:?}");
}

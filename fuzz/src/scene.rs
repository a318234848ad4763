//! Scene files and their diagnostics.

use std::path::Path;

use glam::DVec3;
use miette::{Diagnostic as _, GraphicalReportHandler, GraphicalTheme, Severity};
use vkpt::scene::{
    Diagnostic, Errors, Geometry, LARGEST_SIDE, Material, MaterialKind, Place, Read, Scene, Shape,
    parse,
};

/// A scene that keeps its promises, or errors that point into the text; and with `strict` errors for warnings.
pub fn scene(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let [read, strict] = [false, true].map(|strict| parse(&text, Path::new("fuzz.scn"), strict));
    let clean = matches!(&read, Ok(read) if read.warnings.is_empty());
    assert_eq!(strict.is_ok(), clean, "--strict");
    let diagnostics = match &read {
        Ok(Read { warnings, .. }) => warnings,
        Err(Errors { diagnostics, .. }) => diagnostics,
    };
    diagnostics_are_sound(diagnostics);
    let errors = diagnostics.iter().any(|d| d.severity == Severity::Error);
    assert_eq!(errors, read.is_err(), "errors");
    if let Ok(read) = read {
        promises_kept(&read.scene);
        super::prepared::is_prepared(&read.scene);
    }
}

/// Each diagnostic points into the text at its place, in file order; the first is drawn.
fn diagnostics_are_sound(diagnostics: &[Diagnostic]) {
    let start = |d: &Diagnostic| d.place.map_or(usize::MAX, |place| place.start);
    assert!(diagnostics.is_sorted_by_key(start));
    diagnostics.iter().for_each(|d| super::has_message(d));
    if let Some(first) = diagnostics.first() {
        is_drawn(first);
    }
    let text = diagnostics.iter().find_map(text_of).unwrap_or_default();
    for place in diagnostics.iter().filter_map(|d| d.place) {
        points_into(&text, place);
    }
}

pub fn is_drawn(diagnostic: &Diagnostic) {
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none());
    let mut drawn = String::new();
    let done = handler.render_report(&mut drawn, diagnostic);
    assert!(done.is_ok(), "{diagnostic:?}");
    let control = |c: char| c.is_control() && c != '\n';
    assert!(!drawn.contains(control), "{drawn:?}");
}

/// The whole text into which a diagnostic points, if any.
fn text_of(diagnostic: &Diagnostic) -> Option<String> {
    let whole = (0, 0).into();
    let span = diagnostic.source_code()?.read_span(&whole, 0, 1 << 30);
    let bytes = span.expect("a text that is not empty").data().to_vec();
    Some(String::from_utf8(bytes).expect("UTF-8"))
}

/// The place lies on one line of the text, and its line and column are those of its first byte.
fn points_into(text: &str, place: Place) {
    let culprit = text.get(place.start..place.start + place.length);
    let culprit = culprit.unwrap_or_else(|| panic!("{place:?} is not in {text:?}"));
    assert!(!culprit.contains('\n'), "{place:?}");
    let before = text[..place.start].rsplit('\n').next().unwrap_or_default();
    assert_eq!(place.column, before.chars().count() + 1, "{place:?}");
    let lines = text[..place.start].matches('\n').count();
    assert_eq!(place.line, lines + 1, "{place:?}");
}

/// Checks a scene against the format's limits, in single precision too.
pub fn promises_kept(scene: &Scene) {
    let camera = scene.camera;
    for side in [scene.screen.width, scene.screen.height] {
        assert!((1..=LARGEST_SIDE).contains(&side));
    }
    assert!(camera.ry as f32 > 0.0 && finite(camera.eye) && camera.orientation.is_normalized());
    if let Some(lens) = scene.lens {
        assert!(lens.radius >= 0.0 && lens.focus as f32 > 0.0);
        assert!([lens.radius, lens.focus].map(|x| (x as f32).is_finite()) == [true; 2]);
    }
    assert!(is_radiance(scene.background));
    scene.materials.iter().for_each(is_legal);
    for shape in &scene.shapes {
        assert!(shape.material < scene.materials.len());
        is_solid(shape);
    }
}

fn finite(v: DVec3) -> bool {
    v.as_vec3().is_finite()
}

fn is_radiance(v: DVec3) -> bool {
    finite(v) && v.min_element() >= 0.0
}

fn is_legal(material: &Material) {
    match &material.kind {
        MaterialKind::Light(radiance) => assert!(is_radiance(*radiance)),
        MaterialKind::Brdf(brdf) => {
            for colour in [brdf.kd, brdf.ks, brdf.kt] {
                assert!(colour.min_element() >= 0.0 && colour.max_element() <= 1.0);
            }
            assert!(brdf.alpha >= 0.0 && (brdf.alpha as f32).is_finite());
            assert!(brdf.ior as f32 > 0.0);
        }
    }
}

fn is_solid(shape: &Shape) {
    assert!(match &shape.geometry {
        Geometry::Sphere { centre, radius } => finite(*centre) && *radius as f32 > 0.0,
        Geometry::Box { corner, diagonal } =>
            finite(*corner) && diagonal.as_vec3().abs().min_element() > 0.0,
        Geometry::Cylinder { base, axis, radius } =>
            finite(*base) && axis.length() as f32 > 0.0 && *radius as f32 > 0.0,
        Geometry::Mesh(mesh) => mesh.scale as f32 > 0.0 && mesh.rotate.is_normalized(),
    });
}

//! The camera and the background.

use glam::DVec3;
use serde_json::{Value, json};

use super::{Reason, Remark};
use crate::export::Subject;
use vkpt::prepared::Prepared;

/// Width of the picture when vkpt reads an aspect ratio.
const WIDTH: u32 = 400;

/// Refusals that concern the lens and the background.
pub fn refusals(subject: &Subject) -> Vec<Remark<Reason>> {
    let scene = subject.scene;
    let lens = scene.lens.filter(|lens| lens.radius > 0.0);
    let lens = lens.map(|lens| Remark::new(lens.line, Reason::Lens));
    let outside = match (shines(subject.prepared), scene.background) {
        _ if scene.surroundings.is_some() => Some(Reason::Background),
        (true, DVec3::ZERO) | (false, DVec3::ONE) => None,
        (false, DVec3::ZERO) => Some(Reason::Dark),
        _ => Some(Reason::Background),
    };
    // Without a line for the background, the remark goes to the camera's line.
    let line = match scene.background_line {
        0 => scene.camera_line,
        line => line,
    };
    let outside = outside.map(|reason| Remark::new(line, reason));
    lens.into_iter().chain(outside).collect()
}

/// Whether a shape emits light.
fn shines(prepared: &Prepared) -> bool {
    let material = |i: u32| &prepared.materials[i as usize];
    let mut shapes = prepared.shapes.iter();
    shapes.any(|shape| material(shape.material).radiance != DVec3::ZERO)
}

/// glTF stores the aspect ratio of a picture but not its size.
pub fn note(subject: &Subject) -> Option<Remark<String>> {
    let camera = &subject.prepared.camera;
    let [width, height] = [camera.width, camera.height];
    let read = (f64::from(WIDTH) / aspect(subject)).round();
    let is_kept = width == WIDTH && f64::from(height) == read;
    (!is_kept).then(|| {
        let what = format!(
            "glTF does not store the size in pixels: render the file with --size {width}x{height}"
        );
        Remark::new(subject.scene.camera_line, what)
    })
}

fn aspect(subject: &Subject) -> f64 {
    let camera = &subject.prepared.camera;
    f64::from(camera.width) / f64::from(camera.height)
}

/// Both cameras look down −Z, X right, Y up.
pub fn node(subject: &Subject) -> Value {
    let camera = &subject.scene.camera;
    json!({
        "name": "camera",
        "camera": 0,
        "translation": camera.eye.to_array(),
        "rotation": camera.orientation.to_array(),
    })
}

/// ry = tan(yfov/2)
pub fn camera(subject: &Subject) -> Value {
    let eye = &subject.prepared.camera;
    let unit = subject.prepared.space.unit;
    json!({
        "type": "perspective",
        "perspective": {
            "yfov": 2.0 * subject.scene.camera.ry.atan(),
            "aspectRatio": f64::from(eye.width) / f64::from(eye.height),
            // glTF requires a near plane; vkpt clips nothing.
            "znear": NEAR * unit,
        },
    })
}

/// In units of rendering space, where no shape is farther than 4 from the eye: in single precision anything nearer is
/// indistinguishable from the eye.
const NEAR: f64 = 1.0 / 65536.0;

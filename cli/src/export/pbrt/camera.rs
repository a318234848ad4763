//! The statements before `WorldBegin`: the camera, its film, sampler and integrator.

use glam::{DMat4, DVec3};

use super::statement::Statement;
use super::surface::medium_name;
use crate::export::Subject;
use crate::export::seen::absorbs;

/// vkpt's default number of samples.
const SAMPLES: u32 = 64;

/// More bounces than any path has: pbrt counts them in an `int`, and its default is 5.
const UNLIMITED: u32 = i32::MAX as u32;

/// The statements, including the camera's transform.
pub fn statements(subject: &Subject) -> Vec<Statement> {
    let mut statements = vec![
        film(subject),
        // Uniform points in a pixel with equal weights.
        Statement::new("PixelFilter")
            .word("box")
            .float("xradius", 0.5)
            .float("yradius", 0.5),
        Statement::new("Sampler")
            .word("independent")
            .integer("pixelsamples", SAMPLES),
        // Both programs count bounces.
        Statement::new("Integrator")
            .word("volpath")
            .integer("maxdepth", subject.model.max_depth.unwrap_or(UNLIMITED)),
    ];
    let eye_medium = (subject.prepared.materials).get(subject.prepared.eye_medium as usize);
    // The interior is empty; the exterior is the medium around the camera.
    let medium = eye_medium.filter(|glass| absorbs(glass)).map(medium_name);
    let inside = medium.map(|name| Statement::new("MediumInterface").word("").word(&name));
    statements.extend(inside);
    statements.push(Statement::new("Transform").matrix(to_camera(subject)));
    statements.push(camera(subject));
    statements
}

fn film(subject: &Subject) -> Statement {
    let camera = &subject.prepared.camera;
    let film = Statement::new("Film")
        .word("rgb")
        .integer("xresolution", camera.width)
        .integer("yresolution", camera.height)
        .boolean("savefp16", false);
    match subject.crop {
        None => film,
        Some([x0, y0, x1, y1]) => film.integers("pixelbounds", &[x0, x1, y0, y1]),
    }
}

/// From the world to the camera, which looks along +Z where vkpt's looks along −Z; X is to the right in both.
fn to_camera(subject: &Subject) -> DMat4 {
    let camera = &subject.scene.camera;
    let turned = DMat4::from_quat(camera.orientation.conjugate());
    DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)) * turned * DMat4::from_translation(-camera.eye)
}

fn camera(subject: &Subject) -> Statement {
    let picture = &subject.prepared.camera;
    // pbrt's field of view is that of the shorter side, `ry` that of the height.
    let shorter = f64::from(picture.width.min(picture.height)) / f64::from(picture.height);
    let fov = 2.0 * (subject.scene.camera.ry * shorter).atan();
    let camera = Statement::new("Camera")
        .word("perspective")
        .float("fov", fov.to_degrees());
    match subject.scene.lens.filter(|lens| lens.radius > 0.0) {
        Some(lens) => camera
            .float("lensradius", lens.radius)
            .float("focaldistance", lens.focus),
        None => camera,
    }
}

//! The lens of a scene in rendering space, its limits in single precision, and solids that intersect it.

use std::f64::consts::TAU;

use glam::DVec3;

use super::placed::Placed;
use super::range::ULP;
use super::{Camera, Lens, PrepareError};
use crate::scene;
use crate::shape::{Body, Bounds, Space};

/// A box around the eye and its lens, in the scene.
pub fn bounds(eye: DVec3, lens: Option<scene::Lens>) -> Bounds {
    let radius = lens.map_or(0.0, |lens| lens.radius);
    Bounds::around([eye - radius, eye + radius])
}

/// The lens around `camera`'s eye; `None` if its radius is 0, which is a pinhole.
///
/// The ray from the lens's point l through the point d1 of the picture plane, at distance 1, meets that of the pinhole
/// in the plane at the distance F: F d1 = l + s d, d ∝ d1 − l/F. In pixels, H/(2 ry) to a unit of the picture plane,
/// the edge of the lens moves d1 by R/F · H/(2 ry).
pub fn lens(
    lens: Option<scene::Lens>,
    camera: &Camera,
    space: &Space,
) -> Result<Option<Lens>, PrepareError> {
    let Some(lens) = lens.filter(|lens| lens.radius > 0.0) else {
        return Ok(None);
    };
    let radius = space.length(lens.radius);
    let tangent = lens.radius / lens.focus;
    let blur = tangent * f64::from(camera.height) / (2.0 * camera.up.length());
    // The length of F d1 − l over F, which both renderers square; 16 allows for the terms added to it.
    let fits = |length: f64| 16.0 * length * length < f64::from(f32::MAX);
    if !(fits(tangent) && fits(blur)) {
        return Err(PrepareError::Lens { line: lens.line });
    }
    Ok(Some(Lens {
        right: camera.right.normalize() * radius,
        up: camera.up.normalize() * radius,
        blur,
        line: lens.line,
    }))
}

/// Warns if rays miss their point in the plane of focus by more than a pixel: directions are rounded to an ulp of 1,
/// which over the length ℓ = √(R² + F²), under the cosine F/ℓ, is ℓ²/F of that plane and ℓ²/F² of the one at distance 1.
pub fn warn_of_wide(camera: &Camera, lens: &Lens, warnings: &mut Vec<String>) {
    let pixel = 2.0 * camera.up.length() / f64::from(camera.height);
    let tangent = lens.blur * pixel;
    let off = ULP * (1.0 + tangent * tangent) / pixel;
    if off > 1.0 {
        warnings.push(format!(
            "line {}: the lens is {tangent:.0e} times as wide as its focal distance: in single precision the rays of its edge \
             miss their points of the focal plane by {off:.0e} pixels",
            lens.line
        ));
    }
}

/// Number of points on the lens's edge that are checked.
const EDGE: u32 = 32;

/// Warns about a solid that contains only part of the lens; meshes are not checked.
pub fn warn_of_crossing(eye: DVec3, lens: &Lens, placed: &Placed, warnings: &mut Vec<String>) {
    let radius = lens.right.length();
    let at = |turn: f64| lens.right * turn.cos() + lens.up * turn.sin();
    let edge: Vec<DVec3> = (0..EDGE)
        .map(|i| eye + at(TAU * f64::from(i) / f64::from(EDGE)))
        .collect();
    let crosses = |body: &dyn Body| {
        let nearest = nearest_point(eye, lens, body.bounds().centre());
        let inside = body.contains(eye);
        body.distance(eye).is_some_and(|d| d <= radius)
            && (edge.iter().chain([&nearest])).any(|p| body.contains(*p) != inside)
    };
    if let Some(shape) = placed.shapes.iter().find(|s| crosses(&*placed.body(s))) {
        warnings.push(format!(
            "line {}: the lens reaches through the surface of the shape of line {}: rays start inside and outside of it, all of \
             them in the medium of the eye",
            lens.line, shape.line
        ));
    }
}

/// The point of the lens that is nearest to `p`.
fn nearest_point(eye: DVec3, lens: &Lens, p: DVec3) -> DVec3 {
    let along = |axis: DVec3| (p - eye).dot(axis) / axis.length_squared();
    let (x, y) = (along(lens.right), along(lens.up));
    let beyond = x.hypot(y).max(1.0);
    eye + (lens.right * x + lens.up * y) / beyond
}

//! Warnings about pictures that can only be black: nothing emits light, or the eye is enclosed away from all emitters.

use glam::DVec3;

use super::medium::overlap;
use super::placed::Placed;
use super::{Light, Material, NONE, Prepared, Shape, ShapeKind};
use crate::shape::{Body, Bounds};

/// Warns if nothing emits light.
pub fn warn_of_no_light(lights: &[Light], warnings: &mut Vec<String>) {
    if lights.is_empty() {
        warnings.push(
            "the scene has no lights, so the picture is black: put `light r g b` before a shape, or add \
             `background r g b`"
                .to_owned(),
        );
    }
}

/// Warns if the eye is inside an opaque solid that no light reaches into. With a lamp inside, the solid is a room.
/// Meshes are exempt, because opaque ones may be open.
pub fn warn_of_shut_in(
    eye: DVec3,
    placed: &Placed,
    materials: &[Material],
    lights: &[Light],
    warnings: &mut Vec<String>,
) {
    let is_opaque = |s: &&Shape| {
        let material = &materials[s.material as usize];
        let shines = material.radiance.max_element() > 0.0;
        s.kind != ShapeKind::Mesh && !shines && !Prepared::is_transmissive(material)
    };
    let mut solids = placed.shapes.iter().filter(is_opaque);
    let lamps: Vec<&Shape> = lights
        .iter()
        .filter(|light| light.shape != NONE)
        .map(|light| &placed.shapes[light.shape as usize])
        .collect();
    let is_dark = |solid: &&Shape| {
        let body = placed.body(solid);
        body.contains(eye) && !lamps.iter().any(|lamp| reaches_into(placed, lamp, &*body))
    };
    if let Some(solid) = solids.find(is_dark).filter(|_| !lights.is_empty()) {
        warnings.push(format!(
            "the eye is inside the opaque shape of line {}, which contains no light, so the picture is black: move the \
             eye, or put a light inside",
            solid.line
        ));
    }
}

/// Whether part of a lamp's surface may lie inside a solid.
fn reaches_into(placed: &Placed, lamp: &Shape, solid: &dyn Body) -> bool {
    let (lamp_body, bounds) = (placed.body(lamp), solid.bounds());
    if bounds.common(lamp_body.bounds()).min_element() < 0.0 {
        return false;
    }
    // A convex lamp that encloses the whole solid is outside it.
    let goes_around =
        lamp.kind != ShapeKind::Mesh && corners(bounds).all(|p| lamp_body.contains(p));
    !goes_around && overlap(&*lamp_body, solid)
}

fn corners(bounds: Bounds) -> impl Iterator<Item = DVec3> {
    let ends = [bounds.lo, bounds.hi];
    let corner = move |i: usize| DVec3::new(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2].z);
    (0..8).map(corner)
}

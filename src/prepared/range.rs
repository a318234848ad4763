//! What is finite in single precision in the scene file, and no longer where the renderers compute with it.

use glam::DVec3;

use super::geometry::{Bounds, Placed};
use super::{Camera, Material, PrepareError, Shape, ShapeKind};

/// Refuses a camera that is infinite on the device, seen from the middle of the scene; `line` is its own.
pub fn check_camera(camera: &Camera, line: usize) -> Result<(), PrepareError> {
    let refuse = |what| Err(PrepareError::Camera { line, what });
    match (finite(camera.eye), finite(camera.right)) {
        (false, _) => refuse("it stands too far from the scene"),
        (_, false) => refuse("its picture is too wide"),
        _ => Ok(()),
    }
}

/// Refuses an index of refraction whose square is infinite on the device, or that of its inverse.
pub fn check_materials(materials: &[Material]) -> Result<(), PrepareError> {
    // d = n² − 1 and 1/n² − 1: nothing else that comes of n is larger.
    let fits = |m: &&Material| m.d.iter().all(|d| (*d as f32).is_finite());
    match materials.iter().find(|m| !fits(m)) {
        Some(&Material {
            line,
            eta: [_, ior],
            ..
        }) => Err(PrepareError::Ior { line, ior }),
        None => Ok(()),
    }
}

/// Refuses a shape that is infinite on the device, seen from the middle of the scene.
pub fn check_shapes(placed: &Placed) -> Result<(), PrepareError> {
    match placed.shapes.iter().find(|shape| !fits(placed, shape)) {
        Some(shape) => Err(PrepareError::Shape { line: shape.line }),
        None => Ok(()),
    }
}

fn fits(placed: &Placed, shape: &Shape) -> bool {
    let Bounds { lo, hi } = placed.bounds(shape);
    // The diagonal of two finite corners need not be finite.
    let height = match shape.kind {
        ShapeKind::Cylinder => placed.cylinders[shape.first as usize].height,
        _ => 0.0,
    };
    finite(lo) && finite(hi) && (height as f32).is_finite()
}

fn finite(v: DVec3) -> bool {
    v.as_vec3().is_finite()
}

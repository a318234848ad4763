//! An eye on the surface of glass: whether it stands inside, single precision does not tell.

use glam::{DVec2, DVec3};

use super::geometry::Placed;
use super::{Material, Shape, ShapeKind};

/// What f32 surely tells apart, relative to the largest coordinate: the eye and the surface are rounded by half an ulp
/// each, their difference and the root of a hit by as much again; 2⁻²⁴ each.
pub const ACCURACY: f64 = 4.0 / 16_777_216.0;

/// Warns of a transmissive solid whose surface the eye stands on. Of meshes nothing is said.
pub fn warn_of_surface(
    eye: DVec3,
    placed: &Placed,
    materials: &[Material],
    warnings: &mut Vec<String>,
) {
    let is_on = |s: &&Shape| {
        let bounds = placed.bounds(s);
        let largest = [eye, bounds.lo, bounds.hi].map(|v| v.abs().max_element());
        let size = largest.into_iter().fold(0.0, f64::max);
        distance(placed, s, eye).is_some_and(|d| d <= ACCURACY * size)
    };
    if let Some(shape) = placed.transmissive(materials).find(is_on) {
        warnings.push(format!(
            "the eye stands on the surface of the transmissive shape of line {}: whether it sees from within or from \
             without is left to rounding",
            shape.line
        ));
    }
}

/// From `p` to the nearest point of the surface of a solid.
fn distance(placed: &Placed, shape: &Shape, p: DVec3) -> Option<f64> {
    let first = shape.first as usize;
    match shape.kind {
        ShapeKind::Sphere => {
            let s = &placed.spheres[first];
            Some((p.distance(s.centre) - s.radius).abs())
        }
        ShapeKind::Box => {
            let b = &placed.boxes[first];
            let beyond = (p - 0.5 * (b.lo + b.hi)).abs() - 0.5 * (b.hi - b.lo);
            Some((beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)).abs())
        }
        ShapeKind::Cylinder => {
            let c = &placed.cylinders[first];
            let d = p - c.base;
            let z = d.dot(c.w);
            let half = 0.5 * c.height;
            let beyond = DVec2::new((d - c.w * z).length() - c.radius, (z - half).abs() - half);
            Some((beyond.max(DVec2::ZERO).length() + beyond.max_element().min(0.0)).abs())
        }
        ShapeKind::Mesh => None,
    }
}

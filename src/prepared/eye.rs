//! An eye on the surface of glass: single precision cannot say whether it is inside.

use glam::DVec3;

use super::placed::Placed;
use super::{Material, Shape};

/// The smallest difference that f32 resolves reliably, relative to the largest coordinate: the eye and the surface are
/// rounded by half an ulp each, and so are their difference and the root of a hit; 2⁻²⁴ each.
pub const ACCURACY: f64 = 4.0 / 16_777_216.0;

/// Warns if the eye is on the surface of a transmissive solid; meshes are not checked.
pub fn warn_of_surface(
    eye: DVec3,
    placed: &Placed,
    materials: &[Material],
    warnings: &mut Vec<String>,
) {
    let is_on = |s: &&Shape| {
        let body = placed.body(s);
        let bounds = body.bounds();
        let largest = [eye, bounds.lo, bounds.hi].map(|v| v.abs().max_element());
        let size = largest.into_iter().fold(0.0, f64::max);
        body.distance(eye).is_some_and(|d| d <= ACCURACY * size)
    };
    if let Some(shape) = placed.transmissive(materials).find(is_on) {
        warnings.push(format!(
            "the eye is on the surface of the transmissive shape of line {}: rounding decides whether it is inside or \
             outside",
            shape.line
        ));
    }
}

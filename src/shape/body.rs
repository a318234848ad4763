//! The geometric queries on a shape before rendering.

use glam::DVec3;

use super::{Bounds, Space};

/// A solid, or a mesh as a whole.
pub trait Body {
    /// The bounding box.
    fn bounds(&self) -> Bounds;

    /// Whether `p` is inside.
    fn contains(&self, p: DVec3) -> bool;

    /// The area of each primitive.
    fn areas(&self) -> Vec<f64>;

    /// The length that rounding must not lose: the smallest dimension of a solid. For a mesh it is the largest, because
    /// a mesh may be flat, and moving its corners does not tear it.
    fn thickness(&self) -> f64;

    /// Distance from `p` to the nearest point of the surface, if known.
    fn distance(&self, p: DVec3) -> Option<f64>;

    /// Whether it overlaps this ball, given that their bounds do; assumed if unknown.
    fn overlaps_ball(&self, _centre: DVec3, _radius: f64) -> bool {
        true
    }

    /// Centre and radius, if it is a ball.
    fn ball(&self) -> Option<(DVec3, f64)> {
        None
    }
}

/// The unit of intersection tests: a solid, or one triangle.
pub trait Primitive {
    /// The bounding box of the stored numbers: a rounded frame is not quite orthonormal.
    fn extent(&self) -> Bounds;

    /// [`Primitive::extent`] of the device's numbers: each is rounded to f32.
    fn extent_in_f32(&self) -> Bounds;

    /// Transforms it from the scene to rendering space.
    fn move_to(&mut self, space: &Space);

    /// Raises lengths used as divisors to at least `least`.
    fn enlarge(&mut self, _least: f64) {}
}

//! What is asked of a shape before it is rendered.

use glam::DVec3;

use super::{Bounds, Space};

/// A solid, or a mesh as a whole.
pub trait Body {
    /// The smallest box about it.
    fn bounds(&self) -> Bounds;

    /// Whether `p` lies inside.
    fn contains(&self, p: DVec3) -> bool;

    /// The area of each primitive.
    fn areas(&self) -> Vec<f64>;

    /// What must not be lost to rounding: the least measure of a solid. A mesh may be flat, and its corners are moved
    /// without tearing it: its largest.
    fn thickness(&self) -> f64;

    /// From `p` to the nearest point of the surface, where that is known.
    fn distance(&self, p: DVec3) -> Option<f64>;

    /// Whether it overlaps this ball, given that their bounds do; assumed where it is not known.
    fn overlaps_ball(&self, _centre: DVec3, _radius: f64) -> bool {
        true
    }

    /// Centre and radius of what is a ball.
    fn ball(&self) -> Option<(DVec3, f64)> {
        None
    }
}

/// What a ray is tested with: a solid, or one triangle.
pub trait Primitive {
    /// The box about the numbers as they are: a frame that was rounded is not quite orthonormal.
    fn extent(&self) -> Bounds;

    /// [`Primitive::extent`] of what the device gets: each number rounded to f32.
    fn extent_in_f32(&self) -> Bounds;

    /// Moves it from the scene to rendering space.
    fn move_to(&mut self, space: &Space);

    /// Makes lengths that are divided by at least `least`.
    fn enlarge(&mut self, _least: f64) {}
}

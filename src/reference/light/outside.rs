//! The light outside the scene, seen by a path that leaves it; twin of `shaders/light/outside.glsl`.

use crate::reference::math::Vec3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside<F> {
    /// W·sr⁻¹·m⁻².
    pub radiance: Vec3<F>,
    /// Per steradian: the density with which the background as a light draws the direction.
    pub pdf: F,
}

//! What a path sees that leaves the scene; twin of `shaders/light/outside.glsl`.

use crate::reference::math::Vec3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside<F> {
    /// W·sr⁻¹·m⁻².
    pub radiance: Vec3<F>,
    /// Per steradian: that with which the background as a light draws the direction.
    pub pdf: F,
}

//! A vertex where a path is joined; twin of `shaders/integrator/bidirectional/joint.glsl`.

use super::partial::Partial;
use crate::reference::math::Vec3;
use crate::reference::path::vertex::Vertex;

/// One end of a connection.
#[derive(Clone, Copy, Debug)]
pub struct Joint<F> {
    pub v: Vertex<F>,
    /// Back along its path, of unit length.
    pub wo: Vec3<F>,
    /// Throughput of an eye path; for a light path the power that arrives, W.
    pub carried: Vec3<F>,
    /// The medium through which its path came.
    pub medium: u32,
    pub partial: Partial<F>,
    /// Vertices of its path up to this one, including the eye or the light's point.
    pub count: u32,
}

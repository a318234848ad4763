//! A vertex that a path is joined at; twin of `shaders/integrator/bidirectional/joint.glsl`.

use super::partial::Partial;
use crate::reference::math::Vec3;
use crate::reference::path::vertex::Vertex;

/// One end of a connection.
#[derive(Clone, Copy, Debug)]
pub struct Joint<F> {
    pub v: Vertex<F>,
    /// Whence its path came, of unit length.
    pub wo: Vec3<F>,
    /// Throughput of an eye path; of a light path the power that arrives, W.
    pub carried: Vec3<F>,
    /// The medium that its path came through.
    pub medium: u32,
    pub partial: Partial<F>,
    /// Vertices of its path up to this one, the eye or the light's point among them.
    pub count: u32,
}

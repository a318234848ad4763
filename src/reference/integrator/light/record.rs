//! What is written down of a light path: for `--aov light:…` what its surfaces do.

use super::Splat;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::Vertex;

/// Told of each event of a light path, in order; the renderer uses [`Silent`].
pub trait Recorder<F: Real> {
    /// Light has arrived at the eye from a vertex, along this direction from it; from the light itself where that is `None`.
    fn splat(&mut self, _from: Option<(&Vertex<F>, Vec3<F>)>, _splat: Splat<F>) {}
    /// The path after the vertex `v`, whose next direction was drawn from `lobe`.
    fn scattered(&mut self, _path: &Subpath<F>, _v: &Vertex<F>, _lobe: u32) {}
}

/// Writes nothing down.
pub struct Silent;

impl<F: Real> Recorder<F> for Silent {}

//! The events of a light path: for `--aov light:…` the scattering at its surfaces.

use super::Splat;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::Vertex;

/// Receives each event of a light path, in order; the renderer uses [`Silent`].
pub trait Recorder<F: Real> {
    /// Light has arrived at the eye from a vertex, along this direction from it; from the light itself if that is `None`.
    fn splat(&mut self, _from: Option<(&Vertex<F>, Vec3<F>)>, _splat: Splat<F>) {}
    /// The path after the vertex `v`, whose next direction was drawn from `lobe`.
    fn scattered(&mut self, _path: &Subpath<F>, _v: &Vertex<F>, _lobe: u32) {}
}

/// Records nothing.
pub struct Silent;

impl<F: Real> Recorder<F> for Silent {}

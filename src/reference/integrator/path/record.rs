//! The events of a path: all of them for `--trace`, its [`signature`](super::signature) for `compare --paired`.

use super::PathState;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::Vertex;

/// Receives each event of a path, in order; the renderer uses [`Silent`].
pub trait Recorder<F: Real> {
    /// The path has come to the vertex `v`, which is not shaded yet.
    fn hit(&mut self, _s: &PathState<F>, _v: &Vertex<F>) {}
    /// The vertex that the path has come to emits, or the background: `seen` is its weighted radiance times throughput,
    /// which is not yet in the radiance.
    fn emission(&mut self, _seen: Vec3<F>) {}
    /// The light to which this vertex is to be connected, and its contribution if nothing is in the way.
    fn light(&mut self, _s: &PathState<F>, _light: u32, _contribution: Vec3<F>) {}
    /// The state after the vertex `v` was shaded and the next direction drawn from `lobe`.
    fn vertex(&mut self, s: &PathState<F>, v: &Vertex<F>, lobe: u32);
    /// A connection and the light that arrived over it, which is not yet in the radiance; its vertex follows.
    fn connection(&mut self, s: &PathState<F>, c: &ShadowRay<F>, arrived: Option<Vec3<F>>);
    /// The path has left the scene.
    fn escape(&mut self, s: &PathState<F>);
}

/// Records nothing.
pub struct Silent;

impl<F: Real> Recorder<F> for Silent {
    fn vertex(&mut self, _: &PathState<F>, _: &Vertex<F>, _: u32) {}
    fn connection(&mut self, _: &PathState<F>, _: &ShadowRay<F>, _: Option<Vec3<F>>) {}
    fn escape(&mut self, _: &PathState<F>) {}
}

//! The events of the two paths of a sample: all of them for `--trace`, their [`signature`](super::signature) for
//! `compare --paired`.

use super::joint::Joint;
use crate::reference::integrator::light::begin::LightStart;
use crate::reference::integrator::path::pick::candidate::Candidate;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::blocks::Origin;

/// The far end of a connection from a path's last vertex.
#[derive(Clone, Copy, Debug)]
pub enum Far<'a, F> {
    /// From a light path's vertex to this point of the eye, which sees it through this pixel.
    Eye { pixel: u32, point: Vec3<F> },
    /// From an eye path's vertex to a point of a light.
    Light(&'a Candidate<F>),
    /// From an eye path's vertex to one of the light path.
    Vertex(&'a Joint<F>),
}

/// Receives each event of both paths, in order; the renderer uses [`Silent`].
pub trait Recorder<F: Real> {
    /// The light path leaves its light along `path`'s ray with the power `power`, W.
    fn start(&mut self, _start: &LightStart<F>, _path: &Subpath<F>, _power: Vec3<F>) {}
    /// The eye path leaves the eye, or a point of its lens, along `path`'s ray.
    fn looks(&mut self, _path: &Subpath<F>) {}
    /// A path has come to a vertex, which is not shaded yet.
    fn hit(&mut self, _from: Origin, _x: &Joint<F>) {}
    /// The last vertex of the eye path emits, or the background where `on` is `None`: `seen` is its weighted radiance
    /// times throughput. The path is as it arrived.
    fn emission(&mut self, _on: Option<&Joint<F>>, _path: &Subpath<F>, _seen: Vec3<F>) {}
    /// The last vertex is to be connected to a light, which contributes `contribution` if nothing is in the way.
    fn light(&mut self, _light: u32, _contribution: Vec3<F>) {}
    /// A connection of the last vertex, and the light that arrived over it, weighted.
    fn connection(&mut self, _far: Far<F>, _arrived: Option<Vec3<F>>) {}
    /// The path after its last vertex, whose next direction was drawn from `lobe`.
    fn scattered(&mut self, _from: Origin, _path: &Subpath<F>, _lobe: u32) {}
    /// The path has left the scene.
    fn escape(&mut self, _from: Origin, _path: &Subpath<F>) {}
}

/// Records nothing.
pub struct Silent;

impl<F: Real> Recorder<F> for Silent {}

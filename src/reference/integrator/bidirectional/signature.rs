//! The decisions of both paths of a sample as one word; twin of `shaders/integrator/bidirectional/record/`.
//!
//! As in [`path::signature`](crate::reference::integrator::path::signature). At each vertex the light path decides the
//! shape that was hit, the lobe, and the pixels that see the vertex; the eye path also decides to which light it is
//! connected, and over which connections light arrives. The vertices of both and the connections each have a chain.

use glam::DVec3;

use super::joint::Joint;
use super::record::{Far, Recorder};
use crate::layout::constants::decision::{
    DECISION_ARRIVAL, DECISION_ESCAPE, DECISION_LIGHT, DECISION_LOBE, DECISION_SHAPE,
};
use crate::reference::integrator::light::Splat;
use crate::reference::integrator::path::signature::{decide, is_light, path_signature};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::blocks::Origin;

/// The decisions of a sample so far.
#[derive(Clone, Copy, Debug, Default)]
pub struct Signature {
    light_vertices: u32,
    eye_vertices: u32,
    connections: u32,
}

impl Signature {
    /// The word, once both paths have ended and the light path has produced `splats`.
    pub fn word<F: Real>(self, splats: &[Splat<F>]) -> u32 {
        let eye = path_signature(self.eye_vertices, self.connections);
        sample_signature(self.light_vertices, splats, eye)
    }

    fn vertices(&mut self, from: Origin) -> &mut u32 {
        match from {
            Origin::Eye => &mut self.eye_vertices,
            Origin::Light => &mut self.light_vertices,
        }
    }

    fn decide(&mut self, from: Origin, matters: bool, decision: u32, what: u32) {
        let chain = self.vertices(from);
        *chain = decide(*chain, matters, decision, what);
    }
}

/// The signature of a sample whose light path's vertices made the chain `light` and produced `splats`, and whose eye
/// path has the signature `eye`.
pub fn sample_signature<F: Real>(light: u32, splats: &[Splat<F>], eye: u32) -> u32 {
    let arrived = |chain, splat: &Splat<F>| {
        decide(chain, is_light(splat.value), DECISION_ARRIVAL, splat.pixel)
    };
    path_signature(splats.iter().fold(light, arrived), eye)
}

/// The sum of a sample's contributions, `radiance` to its own pixel.
pub fn brought<F: Real>(radiance: Vec3<F>, splats: &[Splat<F>]) -> DVec3 {
    splats
        .iter()
        .fold(radiance.f64(), |sum, splat| sum + splat.value.f64())
}

impl<F: Real> Recorder<F> for Signature {
    fn hit(&mut self, from: Origin, x: &Joint<F>) {
        self.decide(from, is_light(x.carried), DECISION_SHAPE, x.v.shape);
    }

    fn light(&mut self, light: u32, contribution: Vec3<F>) {
        let matters = is_light(contribution);
        self.connections = decide(self.connections, matters, DECISION_LIGHT, light);
    }

    fn connection(&mut self, far: Far<F>, arrived: Option<Vec3<F>>) {
        if !matches!(far, Far::Eye { .. }) {
            let arrived = arrived.is_some_and(is_light);
            self.connections = decide(self.connections, arrived, DECISION_ARRIVAL, 0);
        }
    }

    fn scattered(&mut self, from: Origin, path: &Subpath<F>, lobe: u32) {
        self.decide(from, is_light(path.throughput), DECISION_LOBE, lobe);
    }

    fn escape(&mut self, from: Origin, path: &Subpath<F>) {
        self.decide(from, is_light(path.throughput), DECISION_ESCAPE, 0);
    }
}

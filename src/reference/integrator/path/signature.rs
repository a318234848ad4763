//! The decisions of a path as one word: two paths with the same decisions have the same word. Twin of
//! `shaders/integrator/path/signature.glsl` and `shaders/integrator/path/record/signature.glsl`.
//!
//! The decisions at each vertex are the shape that was hit, the light that was chosen, whether light arrived from it,
//! the lobe, and by roulette whether the path continues, which shows in whether a next shape or an escape follows.
//! Points, directions and triangles within a mesh are no decisions and not in the signature.
//!
//! In the dark there are no decisions: 1e-60 in f64 is 0 in f32, which then traces no connection or ends a path whose
//! light would be invisible. A throughput or a contribution counts if it is above [`DARK`].
//!
//! Vertices and connections each have a chain, because the kernel traces a connection a turn after its vertex. Two
//! paths with different decisions have the same signature with a probability of 2⁻³².

use super::PathState;
use super::record::Recorder;
use crate::layout::constants::decision::{
    DARK, DECISION_ARRIVAL, DECISION_ESCAPE, DECISION_LIGHT, DECISION_LOBE, DECISION_SHAPE,
};
use crate::reference::math::{Real, Vec3, max_component};
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::Vertex;
use crate::reference::sampler::pcg4d::pcg4d;

/// `chain` with one more decision, its kind and its value; unchanged unless the decision `matters`.
pub fn decide(chain: u32, matters: bool, decision: u32, what: u32) -> u32 {
    let longer = pcg4d([chain, decision, what, 0])[0];
    if matters { longer } else { chain }
}

/// Whether this throughput or radiance is above zero.
pub fn is_light<F: Real>(radiance: Vec3<F>) -> bool {
    max_component(radiance) > F::new(DARK)
}

/// The signature of a path whose vertices and connections made these chains.
pub fn path_signature(vertices: u32, connections: u32) -> u32 {
    decide(vertices, true, 0, connections)
}

/// The decisions of one path so far.
#[derive(Clone, Copy, Debug, Default)]
pub struct Signature {
    vertices: u32,
    connections: u32,
}

impl Signature {
    /// The word, once the path has ended.
    pub fn word(self) -> u32 {
        path_signature(self.vertices, self.connections)
    }
}

impl<F: Real> Recorder<F> for Signature {
    fn hit(&mut self, s: &PathState<F>, v: &Vertex<F>) {
        self.vertices = decide(
            self.vertices,
            is_light(s.path.throughput),
            DECISION_SHAPE,
            v.shape,
        );
    }

    fn light(&mut self, _: &PathState<F>, light: u32, contribution: Vec3<F>) {
        self.connections = decide(
            self.connections,
            is_light(contribution),
            DECISION_LIGHT,
            light,
        );
    }

    fn vertex(&mut self, s: &PathState<F>, _: &Vertex<F>, lobe: u32) {
        self.vertices = decide(
            self.vertices,
            is_light(s.path.throughput),
            DECISION_LOBE,
            lobe,
        );
    }

    fn connection(&mut self, _: &PathState<F>, _: &ShadowRay<F>, arrived: Option<Vec3<F>>) {
        let arrived = arrived.is_some_and(is_light);
        self.connections = decide(self.connections, arrived, DECISION_ARRIVAL, 0);
    }

    fn escape(&mut self, s: &PathState<F>) {
        self.vertices = decide(
            self.vertices,
            is_light(s.path.throughput),
            DECISION_ESCAPE,
            0,
        );
    }
}

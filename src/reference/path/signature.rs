//! The decisions of a path as one word: two paths that decided alike have the same. Twin of
//! `shaders/path/signature.glsl` and `shaders/path/record/signature.glsl`.
//!
//! Decided are, at each vertex, the shape that was hit, the light that was chosen, whether the connection to it was
//! made and whether it arrived, the lobe, and by roulette whether the path goes on: the next vertex or the escape is
//! there or not. Not decided, and not in the signature, are points, directions and triangles within a mesh.
//!
//! Vertices and connections each have a chain, because the kernel flies a connection a turn after its vertex.
//! Two paths that decided otherwise have the same signature with a probability of 2⁻³².

use super::PathState;
use super::flight::ShadowRay;
use super::record::Recorder;
use super::vertex::Vertex;
use crate::reference::math::{Real, Vec3};
use crate::reference::sampler::random::pcg4d;

const DECISION_VERTEX: u32 = 1;
const DECISION_ESCAPE: u32 = 2;
const DECISION_LIGHT: u32 = 3;
const DECISION_CONNECTION: u32 = 4;

/// `chain` with one more decision: its kind, and what was decided.
pub fn decide(chain: u32, decision: u32, a: u32, b: u32) -> u32 {
    pcg4d([chain, decision, a, b])[0]
}

/// Of a path whose vertices and whose connections made these chains.
pub fn path_signature(vertices: u32, connections: u32) -> u32 {
    decide(vertices, 0, connections, 0)
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
    fn light(&mut self, light: usize) {
        self.connections = decide(self.connections, DECISION_LIGHT, light as u32, 0);
    }

    fn vertex(&mut self, _: &PathState<F>, v: &Vertex<F>, lobe: u32) {
        self.vertices = decide(self.vertices, DECISION_VERTEX, v.shape, lobe);
    }

    fn connection(&mut self, _: &PathState<F>, _: &ShadowRay<F>, arrived: Option<Vec3<F>>) {
        let visible = u32::from(arrived.is_some());
        self.connections = decide(self.connections, DECISION_CONNECTION, visible, 0);
    }

    fn escape(&mut self, _: &PathState<F>) {
        self.vertices = decide(self.vertices, DECISION_ESCAPE, 0, 0);
    }
}

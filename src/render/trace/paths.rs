//! The vertices of a sample's two paths, and the whole paths that they make where they are joined.

use super::chain::{Bounce, End};
use crate::reference::integrator::bidirectional::joint::Joint;
use crate::reference::integrator::light::begin::LightStart;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::Origin;

/// A vertex of either path, and whether it was left by a delta lobe.
#[derive(Clone, Copy)]
pub struct Step<F> {
    pub joint: Joint<F>,
    /// Not set for a vertex that is being connected.
    pub delta: bool,
}

/// Both paths so far.
pub struct Paths<F> {
    /// The eye path's origin.
    pub eye_point: Vec3<F>,
    pub start: Option<LightStart<F>>,
    pub light: Vec<Step<F>>,
    pub eye: Vec<Step<F>>,
}

impl<F: Real> Paths<F> {
    /// No vertex yet.
    pub fn new(eye: Vec3<F>) -> Self {
        Self {
            eye_point: eye,
            start: None,
            light: Vec::new(),
            eye: Vec::new(),
        }
    }

    pub fn steps(&mut self, from: Origin) -> &mut Vec<Step<F>> {
        match from {
            Origin::Eye => &mut self.eye,
            Origin::Light => &mut self.light,
        }
    }

    /// The first `count` vertices of the eye path, the last of which is left along `last`.
    pub fn eye_bounces(&self, count: usize, last: Vec3<F>) -> Vec<Bounce<F>> {
        let steps = &self.eye[..count];
        let next = steps.iter().skip(1).map(|s| -s.joint.wo).chain([last]);
        let bounce = |(s, wi): (&Step<F>, Vec3<F>)| Bounce {
            v: s.joint.v,
            wo: s.joint.wo,
            wi,
            delta: s.delta,
        };
        steps.iter().zip(next).map(bounce).collect()
    }

    /// The light path back from its vertex number `from`, which is left towards the eye along `first`.
    pub fn light_bounces(&self, from: usize, first: Vec3<F>) -> Vec<Bounce<F>> {
        let steps = &self.light[..=from];
        let next = steps.iter().rev().map(|s| -s.joint.wo);
        let wo = [first].into_iter().chain(next);
        let bounce = |((i, s), wo): ((usize, &Step<F>), Vec3<F>)| Bounce {
            v: s.joint.v,
            wo,
            wi: s.joint.wo,
            // The joined vertex scatters by a lobe with a density.
            delta: s.delta && i > 0,
        };
        steps.iter().rev().enumerate().zip(wo).map(bounce).collect()
    }

    /// The point where the light path began, as its first vertex sees it.
    pub fn begun(&self) -> Option<End<F>> {
        let (start, first) = (self.start?, self.light.first()?);
        Some(End::Point {
            light: start.light,
            prim: start.point.prim,
            p: start.point.p,
            cosine: dot3(first.joint.wo, start.point.n).abs(),
        })
    }
}

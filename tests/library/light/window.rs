//! Parts of the sphere of directions, divided into bins of the unit square.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;
use vkpt::reference::math::frame::{Frame, frame_about, to_local, to_world};
use vkpt::reference::math::{Vec3, vec3};

/// Bins along each side of the square. Each wants 40 × 40 nodes or more (model.md, "Samples against density").
pub const BINS: usize = 20;
const NODES: usize = 50;

/// Directions (√(1 − z²) cos φ, √(1 − z²) sin φ, z) in `frame`, z and φ from intervals.
pub struct Window {
    frame: Frame<f64>,
    z: [f64; 2],
    /// φ = `middle` + `half` · (2a − 1), or `half` · sin(π/2 (2a − 1)), a in [0, 1].
    middle: f64,
    half: f64,
    graded: bool,
}

impl Window {
    /// All directions within the angle of cosine `z` about `axis`.
    pub fn cone(axis: DVec3, z: f64) -> Self {
        let frame = frame_about(Vec3::new(axis.normalize()));
        Self {
            frame,
            z: [z, 1.0],
            middle: 0.0,
            half: PI,
            graded: false,
        }
    }

    /// Between two planes through `axis` that touch a cylinder, about the azimuth of `towards`. Seen from the side,
    /// a density per area of the side goes to infinity at these planes as 1/√x; a graded φ takes that away.
    pub fn beside(axis: DVec3, towards: DVec3, half: f64, z: [f64; 2]) -> Self {
        let frame = frame_about(Vec3::new(axis.normalize()));
        let t = to_local(frame, Vec3::new(towards));
        Self {
            frame,
            z,
            middle: t.y.atan2(t.x),
            half,
            graded: true,
        }
    }

    /// The direction at (a, b), and the solid angle per unit of the square.
    fn at(&self, a: f64, b: f64) -> (Vec3<f64>, f64) {
        let x = 2.0 * a - 1.0;
        let (part, slope) = match self.graded {
            true => ((FRAC_PI_2 * x).sin(), FRAC_PI_2 * (FRAC_PI_2 * x).cos()),
            false => (x, 1.0),
        };
        let phi = self.middle + self.half * part;
        let z = self.z[0] + (self.z[1] - self.z[0]) * b;
        let r = (1.0 - z * z).max(0.0).sqrt();
        let d = to_world(self.frame, vec3(r * phi.cos(), r * phi.sin(), z));
        (d, 2.0 * self.half * slope * (self.z[1] - self.z[0]))
    }

    /// The bin of a direction; `None` outside.
    pub fn bin(&self, d: Vec3<f64>) -> Option<usize> {
        let l = to_local(self.frame, d);
        let b = (l.z - self.z[0]) / (self.z[1] - self.z[0]);
        let turned = (l.y.atan2(l.x) - self.middle + 3.0 * PI).rem_euclid(TAU) - PI;
        let part = turned / self.half;
        let x = if self.graded {
            part.clamp(-1.0, 1.0).asin() / FRAC_PI_2
        } else {
            part
        };
        let a = (x + 1.0) / 2.0;
        let cell = |x: f64| ((x * BINS as f64) as usize).min(BINS - 1);
        let within = (-1e-9..=1.0 + 1e-9).contains(&b) && part.abs() <= 1.0 + 1e-9;
        within.then(|| cell(a) * BINS + cell(b.max(0.0)))
    }

    /// ∫ f dω over each bin, midpoint rule.
    pub fn integrate(&self, f: impl Fn(Vec3<f64>) -> f64) -> Vec<f64> {
        let n = BINS * NODES;
        let mut bins = vec![0.0; BINS * BINS];
        for i in 0..n {
            for j in 0..n {
                let (d, per) = self.at((i as f64 + 0.5) / n as f64, (j as f64 + 0.5) / n as f64);
                bins[i / NODES * BINS + j / NODES] += f(d) * per / (n * n) as f64;
            }
        }
        bins
    }
}

//! A light as the tree sees it.

use glam::DVec3;

use super::cone::Cone;
use crate::prepared::placed::Placed;
use crate::prepared::{Light, ShapeKind};
use crate::shape::Bounds;

/// A light with a position.
#[derive(Clone, Debug)]
pub struct Emitter {
    pub light: u32,
    pub bounds: Bounds,
    /// The ball around it.
    pub centre: DVec3,
    pub radius: f64,
    pub cone: Cone,
    /// Radiance times the area seen from afar, summed over RGB.
    pub power: f64,
}

impl Emitter {
    /// The light with index `i`; `None` for the background.
    pub fn new(placed: &Placed, light: &Light, i: u32) -> Option<Self> {
        let shape = placed.shapes.get(light.shape as usize)?;
        let body = placed.body(shape);
        let bounds = body.bounds();
        let (centre, radius) = body.ball().unwrap_or((bounds.centre(), bounds.radius()));
        let (cone, seen) = match shape.kind {
            ShapeKind::Mesh => mesh(placed, light),
            // A convex body shows a quarter of its surface on average (Cauchy).
            _ => (Cone::ALL, 0.25),
        };
        let area: f64 = body.areas().iter().sum();
        Some(Self {
            light: i,
            bounds,
            centre,
            radius,
            cone,
            power: area * seen * light.radiance.element_sum(),
        })
    }
}

/// The cone around a mesh's normals, and the largest share of its area that is visible at once; one half if they point
/// everywhere.
fn mesh(placed: &Placed, light: &Light) -> (Cone, f64) {
    let range = light.first as usize..(light.first + light.count) as usize;
    let normals = placed.primitives.triangles[range].iter().map(|t| {
        let [a, b, c] = t.v;
        (b - a).cross(c - a)
    });
    let cones = normals.filter(|n| *n != DVec3::ZERO).map(Cone::of);
    let cone = cones.reduce(Cone::union).unwrap_or(Cone::ALL);
    (cone, if cone.cosine > 0.0 { 1.0 } else { 0.5 })
}

//! Brute force over all primitives, and what two hits have to agree in.

use vkpt::prepared::Prepared;
use vkpt::reference::accel::Primitives;
use vkpt::reference::math::Real;
use vkpt::reference::shape::{
    Cuboid, Cylinder, Hit, Sphere, Triangle, nearest_boxes, nearest_cylinders, nearest_spheres,
    nearest_triangles, no_hit,
};

use super::rays::Query;

/// The primitives of a scene in a scalar.
pub struct World<F> {
    spheres: Vec<Sphere<F>>,
    boxes: Vec<Cuboid<F>>,
    cylinders: Vec<Cylinder<F>>,
    triangles: Vec<Triangle<F>>,
}

impl<F: Real> World<F> {
    pub fn new(prepared: &Prepared) -> Self {
        Self {
            spheres: prepared
                .spheres
                .iter()
                .map(|r| Sphere::rounded(r, F::new))
                .collect(),
            boxes: prepared
                .boxes
                .iter()
                .map(|r| Cuboid::rounded(r, F::new))
                .collect(),
            cylinders: prepared
                .cylinders
                .iter()
                .map(|r| Cylinder::rounded(r, F::new))
                .collect(),
            triangles: prepared.triangles.iter().map(Triangle::new).collect(),
        }
    }

    pub fn primitives(&self) -> Primitives<'_, F> {
        Primitives {
            spheres: &self.spheres,
            boxes: &self.boxes,
            cylinders: &self.cylinders,
            triangles: &self.triangles,
        }
    }

    /// Every primitive tried.
    pub fn nearest(&self, q: &Query<F>) -> Hit<F> {
        let mut best = no_hit(q.t_max);
        best = nearest_spheres(&self.spheres, q.ray, q.skip, best);
        best = nearest_boxes(&self.boxes, q.ray, q.skip, best);
        best = nearest_cylinders(&self.cylinders, q.ray, q.skip, best);
        nearest_triangles(&self.triangles, q.ray, q.skip, best)
    }
}

/// Every bit of a hit; conversion to `f64` is exact.
pub fn bits<F: Real>(hit: Hit<F>) -> [u64; 5] {
    let [u, v] = hit.uv;
    [
        hit.t.f64().to_bits(),
        u64::from(hit.shape),
        u64::from(hit.prim),
        u.f64().to_bits(),
        v.f64().to_bits(),
    ]
}

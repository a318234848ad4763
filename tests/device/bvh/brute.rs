//! Brute force over all primitives, and the values in which two hits must agree.

use vkpt::prepared::{NONE, Prepared};
use vkpt::reference::math::Real;
use vkpt::reference::primitives::Primitives;
use vkpt::reference::shape::{
    Hit, nearest_boxes, nearest_cylinders, nearest_spheres, nearest_triangles, no_hit,
};

use super::rays::Query;

/// The primitives of a scene in a scalar.
pub struct World<F> {
    pub primitives: Primitives<F>,
}

impl<F: Real> World<F> {
    pub fn new(prepared: &Prepared) -> Self {
        Self {
            primitives: Primitives::new(&prepared.primitives),
        }
    }

    /// Every primitive tried.
    pub fn nearest(&self, q: &Query<F>) -> Hit<F> {
        let all = &self.primitives;
        let mut best = no_hit(q.t_max);
        best = nearest_spheres(&all.spheres, q.ray, q.skip, best);
        best = nearest_boxes(&all.boxes, q.ray, q.skip, best);
        best = nearest_cylinders(&all.cylinders, q.ray, q.skip, best);
        nearest_triangles(&all.triangles, q.ray, q.skip, best)
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

/// Whether `any` hit is one where there is a nearest, and none where there is none.
pub fn is_some_hit<F: Real>(any: Hit<F>, nearest: Hit<F>) -> bool {
    match nearest.shape == NONE {
        true => bits(any) == bits(nearest),
        false => any.shape != NONE && any.t >= nearest.t,
    }
}

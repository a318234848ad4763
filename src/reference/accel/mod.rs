//! The reference's own acceleration structure: the nearest hit without trying every primitive, the same hit
//! to the last bit.

mod slabs;
mod split;
mod tree;

use super::math::Real;
use super::primitives::Primitives;
use super::shape::cover::{Cover, NoCover};
use super::shape::{Hit, Ray, Target, ray_shear};
use tree::Tree;

/// A hierarchy over the primitives of a scene, numbered through.
pub struct Accel<F> {
    tree: Tree<F>,
}

impl<F: Real> Accel<F> {
    /// The hierarchy over all primitives; the same for the same primitives.
    pub fn build(primitives: &Primitives<F>) -> Self {
        Self {
            tree: Tree::new(&primitives.extents()),
        }
    }

    /// The least of `best` and all hits with the primitives that the hierarchy was built over, by
    /// (t, shape, prim); `skip` is passed over. A search for hits before `t_max` begins with
    /// [`no_hit`](super::shape::no_hit).
    pub fn nearest(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        best: Hit<F>,
    ) -> Hit<F> {
        match primitives.coincident.is_empty() {
            true => self.search(primitives, ray, skip, best, &NoCover),
            false => self.search(primitives, ray, skip, best, primitives),
        }
    }

    fn search(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        mut best: Hit<F>,
        cover: &impl Cover<F>,
    ) -> Hit<F> {
        let shear = ray_shear(ray.d);
        let t_max = best.t;
        self.tree.traverse(ray.o, ray.d, t_max, |number| {
            best = primitives.nearer(number as usize, ray, shear, skip, best, cover);
            best.t
        });
        best
    }
}

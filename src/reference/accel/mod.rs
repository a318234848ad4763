//! The reference's own acceleration structure: it finds the nearest hit without trying every primitive, and the hit is
//! the same to the last bit.

mod build;
mod leaf;
mod node;
mod slabs;
mod split;
mod tree;

use super::math::Real;
use super::primitives::Primitives;
use super::shape::cover::{Cover, NoCover};
use super::shape::{Hit, Ray, Target, ray_shear};
use crate::prepared::NONE;
use tree::Tree;

/// A hierarchy over the primitives of a scene, numbered consecutively.
pub struct Accel<F> {
    tree: Tree<F>,
}

impl<F: Real> Accel<F> {
    /// The hierarchy over all primitives; the same for the same primitives.
    pub fn build(primitives: &Primitives<F>) -> Self {
        Self {
            tree: Tree::new(primitives),
        }
    }

    /// The least, by (t, shape, prim), of `best` and all hits with the primitives that the hierarchy was built over;
    /// `skip` is passed over. A search for hits before `t_max` begins with [`no_hit`](super::shape::no_hit).
    pub fn nearest(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        best: Hit<F>,
    ) -> Hit<F> {
        self.find::<false>(primitives, ray, skip, best)
    }

    /// Any hit before `none`, which is [`no_hit`](super::shape::no_hit), or `none`.
    pub fn any(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        none: Hit<F>,
    ) -> Hit<F> {
        self.find::<true>(primitives, ray, skip, none)
    }

    fn find<const ANY: bool>(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        best: Hit<F>,
    ) -> Hit<F> {
        match primitives.coincident.is_empty() {
            true => self.search::<ANY>(primitives, ray, skip, best, &NoCover),
            false => self.search::<ANY>(primitives, ray, skip, best, primitives),
        }
    }

    fn search<const ANY: bool>(
        &self,
        primitives: &Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        mut best: Hit<F>,
        cover: &impl Cover<F>,
    ) -> Hit<F> {
        let shear = ray_shear(ray.d);
        let mut walk = self.tree.walk(ray);
        while let Some(leaf) = walk.next(best.t) {
            for number in leaf.candidates(ray.o, shear) {
                best = primitives.nearer(number, ray, shear, skip, best, cover);
                if ANY && best.shape != NONE {
                    return best;
                }
            }
        }
        best
    }
}

//! A triangle's part in the search for the nearest hit; twin of `shaders/shape/triangle/nearer.glsl`.

use super::Triangle;
use super::hit::{RayShear, triangle_hit};
use super::origin::is_origin;
use crate::reference::math::Real;
use crate::reference::shape::cover::Cover;
use crate::reference::shape::ray::{Hit, Ray, Target, closer};

/// The nearer of `best` and the hit with triangle number `prim`. A shadow ray's target is passed over.
pub fn nearer_triangle<F: Real>(
    ray: Ray<F>,
    shear: RayShear<F>,
    skip: Target,
    best: Hit<F>,
    triangle: &Triangle<F>,
    prim: u32,
    cover: &impl Cover<F>,
) -> Hit<F> {
    let [v0, v1, v2] = triangle.v;
    let hit = triangle_hit(ray.o, shear, v0, v1, v2);
    let found = hit.t > F::zero()
        && !(triangle.shape == skip.shape && prim == skip.prim)
        && closer(hit.t, triangle.shape, prim, best)
        && !is_origin(ray, triangle, prim, hit)
        && !cover.is_covered(ray, triangle.shape, prim, hit.t, !hit.back);
    if found {
        Hit {
            t: hit.t,
            shape: triangle.shape,
            prim,
            uv: [hit.u, hit.v],
        }
    } else {
        best
    }
}

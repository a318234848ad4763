//! The nearest hit by a loop over each kind of shape; twin of `shaders/shape/linear/`.
//!
//! Each loop takes the best hit so far and returns the best of that and its own, so that they can be
//! called in any order: the least (t, shape, primitive) wins. A search begins with
//! [`no_hit(t_max)`](super::no_hit) and passes over the shape or triangle `skip`.

use super::ray::{Hit, Ray, Target, closer, start_on};
use super::{
    Cuboid, Cylinder, Sphere, Triangle, box_hit, cylinder_hit, nearer_triangle, ray_shear,
    sphere_hit,
};
use crate::reference::math::Real;

/// `best`, or a hit of a solid at `t` ≥ 0 that comes before it.
pub fn nearer_solid<F: Real>(t: F, shape: u32, prim: u32, skip: Target, best: Hit<F>) -> Hit<F> {
    if t >= F::zero() && shape != skip.shape && closer(t, shape, prim, best) {
        Hit {
            t,
            shape,
            prim,
            uv: [F::zero(); 2],
        }
    } else {
        best
    }
}

/// The least of `best` and the hits with `spheres`.
pub fn nearest_spheres<F: Real>(
    spheres: &[Sphere<F>],
    ray: Ray<F>,
    skip: Target,
    mut best: Hit<F>,
) -> Hit<F> {
    for s in spheres {
        let t = sphere_hit(ray.o, ray.d, s.centre, s.radius, start_on(ray, s.shape));
        best = nearer_solid(t, s.shape, 0, skip, best);
    }
    best
}

/// The least of `best` and the hits with `boxes`.
pub fn nearest_boxes<F: Real>(
    boxes: &[Cuboid<F>],
    ray: Ray<F>,
    skip: Target,
    mut best: Hit<F>,
) -> Hit<F> {
    for b in boxes {
        let hit = box_hit(ray.o, ray.d, b.lo, b.hi, start_on(ray, b.shape));
        best = nearer_solid(hit.t, b.shape, hit.face, skip, best);
    }
    best
}

/// The least of `best` and the hits with `cylinders`.
pub fn nearest_cylinders<F: Real>(
    cylinders: &[Cylinder<F>],
    ray: Ray<F>,
    skip: Target,
    mut best: Hit<F>,
) -> Hit<F> {
    for c in cylinders {
        let hit = cylinder_hit(ray.o, ray.d, c, start_on(ray, c.shape), ray.prim);
        best = nearer_solid(hit.t, c.shape, hit.part, skip, best);
    }
    best
}

/// The least of `best` and the hits with `triangles`, which are numbered as in the slice.
pub fn nearest_triangles<F: Real>(
    triangles: &[Triangle<F>],
    ray: Ray<F>,
    skip: Target,
    mut best: Hit<F>,
) -> Hit<F> {
    let shear = ray_shear(ray.d);
    for (prim, triangle) in triangles.iter().enumerate() {
        best = nearer_triangle(ray, shear, skip, best, triangle, prim as u32);
    }
    best
}

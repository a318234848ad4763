//! The nearest hit by trying each primitive; twin of `shaders/shape/linear/`, where the loops are written out.
//!
//! Each takes the best hit so far and returns the best of that and its own, so that they can be
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

/// The nearer of `best` and the hit with `sphere`.
#[inline]
pub fn nearer_sphere<F: Real>(
    ray: Ray<F>,
    skip: Target,
    best: Hit<F>,
    sphere: &Sphere<F>,
) -> Hit<F> {
    let start = start_on(ray, sphere.shape);
    let t = sphere_hit(ray.o, ray.d, sphere.centre, sphere.radius, start);
    nearer_solid(t, sphere.shape, 0, skip, best)
}

/// The nearer of `best` and the hit with `cuboid`.
#[inline]
pub fn nearer_box<F: Real>(ray: Ray<F>, skip: Target, best: Hit<F>, cuboid: &Cuboid<F>) -> Hit<F> {
    let start = start_on(ray, cuboid.shape);
    let hit = box_hit(ray.o, ray.d, cuboid.lo, cuboid.hi, start);
    nearer_solid(hit.t, cuboid.shape, hit.face, skip, best)
}

/// The nearer of `best` and the hit with `cylinder`.
#[inline]
pub fn nearer_cylinder<F: Real>(
    ray: Ray<F>,
    skip: Target,
    best: Hit<F>,
    cylinder: &Cylinder<F>,
) -> Hit<F> {
    let start = start_on(ray, cylinder.shape);
    let hit = cylinder_hit(ray.o, ray.d, cylinder, start, ray.prim);
    nearer_solid(hit.t, cylinder.shape, hit.part, skip, best)
}

/// The least of `best` and the hits with `spheres`.
pub fn nearest_spheres<F: Real>(
    spheres: &[Sphere<F>],
    ray: Ray<F>,
    skip: Target,
    mut best: Hit<F>,
) -> Hit<F> {
    for s in spheres {
        best = nearer_sphere(ray, skip, best, s);
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
        best = nearer_box(ray, skip, best, b);
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
        best = nearer_cylinder(ray, skip, best, c);
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

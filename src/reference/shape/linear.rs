//! The nearest hit by trying each primitive; twin of `shaders/shape/linear/`, where the loops are unrolled.
//!
//! Each function takes the best hit so far and returns the better of that and its own, so they can be called in any
//! order: the least (t, shape, primitive) wins. A search begins with [`no_hit(t_max)`](super::no_hit) and passes over
//! the shape or triangle `skip`. The loops are for shapes without coincident faces.

use super::r#box::box_enters;
use super::cover::{Cover, NoCover};
use super::cylinder::cap_enters;
use super::ray::{Hit, Ray, START_INSIDE, Target, closer, start_on};
use super::{
    CYLINDER_BASE, Cuboid, Cylinder, Sphere, Triangle, box_hit, cylinder_hit, nearer_triangle,
    ray_shear, sphere_hit,
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
    cover: &impl Cover<F>,
) -> Hit<F> {
    let start = start_on(ray, sphere.shape);
    let mut t = sphere_hit(ray.o, ray.d, sphere.centre, sphere.radius, start);
    if t >= F::zero() && t <= best.t && cover.is_covered(ray, sphere.shape, 0, t, false) {
        // A shape that comes first at one point of a sphere comes first at all of them.
        t = -F::one();
    }
    nearer_solid(t, sphere.shape, 0, skip, best)
}

/// The nearer of `best` and the hit with `cuboid`.
#[inline]
pub fn nearer_box<F: Real>(
    ray: Ray<F>,
    skip: Target,
    best: Hit<F>,
    cuboid: &Cuboid<F>,
    cover: &impl Cover<F>,
) -> Hit<F> {
    let (lo, hi, shape) = (cuboid.lo, cuboid.hi, cuboid.shape);
    let mut hit = box_hit(ray.o, ray.d, lo, hi, start_on(ray, shape));
    let enters = box_enters(hit.face, ray.d);
    if hit.t >= F::zero()
        && hit.t <= best.t
        && cover.is_covered(ray, shape, hit.face, hit.t, enters)
    {
        // The entry does not count: take the exit.
        hit = box_hit(ray.o, ray.d, lo, hi, START_INSIDE);
        if cover.is_covered(ray, shape, hit.face, hit.t, false) {
            hit.t = -F::one();
        }
    }
    nearer_solid(hit.t, cuboid.shape, hit.face, skip, best)
}

/// The nearer of `best` and the hit with `cylinder`.
#[inline]
pub fn nearer_cylinder<F: Real>(
    ray: Ray<F>,
    skip: Target,
    best: Hit<F>,
    cylinder: &Cylinder<F>,
    cover: &impl Cover<F>,
) -> Hit<F> {
    let shape = cylinder.shape;
    let mut hit = cylinder_hit(ray.o, ray.d, cylinder, start_on(ray, shape), ray.prim);
    let enters = cap_enters(cylinder, hit.part, ray.d);
    if hit.t >= F::zero()
        && hit.t <= best.t
        && cover.is_covered(ray, shape, hit.part, hit.t, enters)
    {
        // The entry does not count: take the exit. A ray that starts on no part gets a cap as its start.
        hit = cylinder_hit(ray.o, ray.d, cylinder, START_INSIDE, CYLINDER_BASE);
        if cover.is_covered(ray, shape, hit.part, hit.t, false) {
            hit.t = -F::one();
        }
    }
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
        best = nearer_sphere(ray, skip, best, s, &NoCover);
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
        best = nearer_box(ray, skip, best, b, &NoCover);
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
        best = nearer_cylinder(ray, skip, best, c, &NoCover);
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
        best = nearer_triangle(ray, shear, skip, best, triangle, prim as u32, &NoCover);
    }
    best
}

//! Axis-aligned boxes; twin of `shaders/shape/box.glsl`.

use super::ray::{Hit, Ray, Surface};
use super::slab::{Slab, enters, first_of, slab};
use crate::reference::math::{Real, Vec3, max2, min2, vec3};
pub use crate::shape::cuboid::scalar::Cuboid;

/// Distance to a box, or −1, and the face hit: 2·axis + (1 for `hi`, 0 for `lo`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxHit<F> {
    pub t: F,
    pub face: u32,
}

/// The face on the side of `d` across axis `x`, else `y`, else z.
#[inline(always)]
pub fn box_face<F: Real>(x: bool, y: bool, d: Vec3<F>) -> u32 {
    let (axis, along) = if x {
        (0, d.x)
    } else if y {
        (1, d.y)
    } else {
        (2, d.z)
    };
    2 * axis + u32::from(along > F::zero())
}

/// The first hit with a box along the unit vector `d`, or t = −1.
///
/// `start` is the ray's relation to this box. If it leaves to the outside: never. To the inside: at the exit, t ≥ 0,
/// always found. From elsewhere: the least t > 0, so that a ray which starts in the plane of a face is not stopped
/// there. Slabs: Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986.
#[inline(always)]
pub fn box_hit<F: Real>(o: Vec3<F>, d: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>, start: u32) -> BoxHit<F> {
    let x = slab(o.x, d.x, lo.x, hi.x, start);
    let y = slab(o.y, d.y, lo.y, hi.y, start);
    let z = slab(o.z, d.z, lo.z, hi.z, start);
    let near = max2(max2(x.near, y.near), z.near);
    let far = min2(min2(x.far, y.far), z.far);
    let stretch = Slab { near, far };
    BoxHit {
        t: first_of(stretch, start),
        face: if enters(stretch, start) {
            box_face(x.near == near, y.near == near, -d)
        } else {
            box_face(x.far == far, y.far == far, d)
        },
    }
}

/// Whether a ray along `d` goes through a face from outside.
pub fn box_enters<F: Real>(face: u32, d: Vec3<F>) -> bool {
    let along = [d.x, d.y, d.z][(face / 2) as usize];
    (along > F::zero()) == face.is_multiple_of(2)
}

/// The coordinate of a point of a face: the coordinate of the face's plane along the axis `across` it, clamped to the
/// face along the others.
pub fn box_snap<F: Real>(across: bool, upper: bool, p: F, lo: F, hi: F) -> F {
    let plane = if upper { hi } else { lo };
    if across { plane } else { min2(max2(p, lo), hi) }
}

/// The point that was hit, exactly on the face's plane and within the face.
pub fn box_surface<F: Real>(ray: Ray<F>, hit: Hit<F>, cuboid: &Cuboid<F>) -> Surface<F> {
    let (lo, hi) = (cuboid.lo, cuboid.hi);
    let p = ray.o + ray.d * hit.t;
    let axis = hit.prim / 2;
    let upper = hit.prim % 2 == 1;
    let sign = if upper { F::one() } else { -F::one() };
    let along = |k: u32| if axis == k { sign } else { F::zero() };
    let n = vec3(along(0), along(1), along(2));
    Surface {
        p: vec3(
            box_snap(axis == 0, upper, p.x, lo.x, hi.x),
            box_snap(axis == 1, upper, p.y, lo.y, hi.y),
            box_snap(axis == 2, upper, p.z, lo.z, hi.z),
        ),
        ng: n,
        ns: n,
    }
}

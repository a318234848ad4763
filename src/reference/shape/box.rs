//! Axis-aligned boxes; twin of `shaders/shape/box.glsl`.

use super::ray::{Hit, Ray, START_ELSEWHERE, START_INSIDE, Surface};
use super::slab::slab;
use crate::prepared;
use crate::reference::math::{Real, Vec3, max2, min2, vec3};

/// The box { p : lo ≤ p ≤ hi }.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<F> {
    pub lo: Vec3<F>,
    pub hi: Vec3<F>,
    pub shape: u32,
}

impl<F: Real> Cuboid<F> {
    pub fn new(b: &prepared::Cuboid) -> Self {
        Self {
            lo: Vec3::new(b.lo),
            hi: Vec3::new(b.hi),
            shape: b.shape,
        }
    }
}

/// Distance to a box, or −1, and the face hit: 2·axis + (1 for `hi`, 0 for `lo`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxHit<F> {
    pub t: F,
    pub face: u32,
}

/// The first hit with a box along the unit vector `d`, or t = −1.
///
/// `start` is the ray's relation to this very box. To its outside: never. To its inside: where it leaves,
/// t ≥ 0, always found. From elsewhere: the least t > 0, so that a ray which starts in the plane of a face
/// is not stopped there. Slabs: Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986.
pub fn box_hit<F: Real>(o: Vec3<F>, d: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>, start: u32) -> BoxHit<F> {
    let x = slab(o.x, d.x, lo.x, hi.x, start);
    let y = slab(o.y, d.y, lo.y, hi.y, start);
    let z = slab(o.z, d.z, lo.z, hi.z, start);
    let near = max2(max2(x.near, y.near), z.near);
    let far = min2(min2(x.far, y.far), z.far);
    let enters = near > F::zero() && start == START_ELSEWHERE;
    let found = near <= far && far > F::zero() && start == START_ELSEWHERE;
    let t = if enters { near } else { far };
    BoxHit {
        t: if start == START_INSIDE {
            max2(far, F::zero())
        } else if found {
            t
        } else {
            -F::one()
        },
        face: if enters {
            face_towards(vec3(x.near == near, y.near == near, z.near == near), -d)
        } else {
            face_towards(vec3(x.far == far, y.far == far, z.far == far), d)
        },
    }
}

/// The face on the side of `d`, of the first axis that is marked.
fn face_towards<F: Real>(axis: Vec3<bool>, d: Vec3<F>) -> u32 {
    let upper = |c: F| u32::from(c > F::zero());
    if axis.x {
        upper(d.x)
    } else if axis.y {
        2 + upper(d.y)
    } else {
        4 + upper(d.z)
    }
}

/// The point that was hit, exactly on the face's plane and within the face.
pub fn box_surface<F: Real>(ray: Ray<F>, hit: Hit<F>, cuboid: &Cuboid<F>) -> Surface<F> {
    let (lo, hi) = (cuboid.lo, cuboid.hi);
    let p = ray.o + ray.d * hit.t;
    let upper = hit.prim % 2 == 1;
    let sign = if upper { F::one() } else { -F::one() };
    let snap = |axis: u32, p: F, lo: F, hi: F| {
        if hit.prim / 2 != axis {
            min2(max2(p, lo), hi)
        } else if upper {
            hi
        } else {
            lo
        }
    };
    let along = |axis: u32| {
        if hit.prim / 2 == axis {
            sign
        } else {
            F::zero()
        }
    };
    let n = vec3(along(0), along(1), along(2));
    Surface {
        p: vec3(
            snap(0, p.x, lo.x, hi.x),
            snap(1, p.y, lo.y, hi.y),
            snap(2, p.z, lo.z, hi.z),
        ),
        ng: n,
        ns: n,
    }
}

//! Capped cylinders; twin of `shaders/shape/cylinder.glsl`.

use super::ray::{FAR, Hit, Ray, START_ELSEWHERE, START_INSIDE, Surface};
use super::slab::{PARALLEL, Slab, slab};
use crate::prepared;
use crate::reference::math::frame::{Frame, to_local, to_world};
use crate::reference::math::{Real, Vec3, max2, min2, vec3};

/// The solid { base + x u + y v + z w : x² + y² ≤ radius², 0 ≤ z ≤ height }, (u, v, w) orthonormal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<F> {
    pub base: Vec3<F>,
    pub u: Vec3<F>,
    pub v: Vec3<F>,
    pub w: Vec3<F>,
    pub height: F,
    pub radius: F,
    pub shape: u32,
}

/// Parts of a cylinder, as in `prim` of a hit.
pub const CYLINDER_SIDE: u32 = 0;
/// The cap at z = 0.
pub const CYLINDER_BASE: u32 = 1;
/// The cap at z = height.
pub const CYLINDER_TOP: u32 = 2;

impl<F: Real> Cylinder<F> {
    pub fn new(c: &prepared::Cylinder) -> Self {
        Self {
            base: Vec3::new(c.base),
            u: Vec3::new(c.u),
            v: Vec3::new(c.v),
            w: Vec3::new(c.w),
            height: F::new(c.height),
            radius: F::new(c.radius),
            shape: c.shape,
        }
    }
}

/// The cylinder's own axes.
pub fn cylinder_frame<F: Real>(cylinder: &Cylinder<F>) -> Frame<F> {
    Frame {
        t: cylinder.u,
        b: cylinder.v,
        n: cylinder.w,
    }
}

/// Distance to a cylinder, or −1, and the part hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderHit<F> {
    pub t: F,
    pub part: u32,
}

/// The stretch of a ray inside the infinite cylinder x² + y² ≤ r², in the cylinder's frame.
///
/// a t² − 2b t + c = 0 with a = dx² + dy², b = −(ox dx + oy dy), c = ρ² − r² = (ρ − r)(ρ + r). The
/// discriminant b² − a c cancels; it equals a r² − (ox dy − oy dx)², which does not. A ray that starts on the
/// side to the inside has the roots 0 and 2b/a.
pub fn side_stretch<F: Real>(o: Vec3<F>, d: Vec3<F>, radius: F, start: u32, part: u32) -> Slab<F> {
    let inside = start == START_INSIDE;
    let a = d.x * d.x + d.y * d.y;
    let parallel = a < F::new(PARALLEL);
    let b = -(o.x * d.x + o.y * d.y);
    let rho = (o.x * o.x + o.y * o.y).sqrt();
    let c = (rho - radius) * (rho + radius);
    let cross = o.x * d.y - o.y * d.x;
    let disc = a * (radius * radius) - cross * cross;
    let root = max2(disc, F::zero()).sqrt();
    let q = if b < F::zero() { b - root } else { b + root };
    let by_q = q / if parallel { F::one() } else { a };
    let by_c = if q == F::zero() { F::zero() } else { c / q };
    let on_side = inside && part == CYLINDER_SIDE;
    let t0 = if on_side { F::zero() } else { by_c };
    let t1 = if on_side {
        (b + b) / if parallel { F::one() } else { a }
    } else {
        by_q
    };
    let within = inside || (rho < radius && parallel) || (disc >= F::zero() && !parallel);
    let far = if within { F::new(FAR) } else { -F::new(FAR) };
    Slab {
        near: if parallel || !within {
            -far
        } else {
            min2(t0, t1)
        },
        far: if parallel || !within {
            far
        } else {
            max2(t0, t1)
        },
    }
}

/// The first hit with a capped cylinder along the unit vector `d`, or t = −1.
///
/// `start` is the ray's relation to this very cylinder, `part` the part that it starts on. To its
/// outside: never. To its inside: where it leaves, t ≥ 0, always found. From elsewhere: the least t > 0.
/// The solid is a stretch between two planes within an infinite cylinder; a ray meets it where both do.
pub fn cylinder_hit<F: Real>(
    o: Vec3<F>,
    d: Vec3<F>,
    cylinder: &Cylinder<F>,
    start: u32,
    part: u32,
) -> CylinderHit<F> {
    let frame = cylinder_frame(cylinder);
    let ol = to_local(frame, o - cylinder.base);
    let dl = to_local(frame, d);
    let side = side_stretch(ol, dl, cylinder.radius, start, part);
    let caps = slab(ol.z, dl.z, F::zero(), cylinder.height, start);
    let near = max2(side.near, caps.near);
    let far = min2(side.far, caps.far);
    let enters = near > F::zero() && start == START_ELSEWHERE;
    let found = near <= far && far > F::zero() && start == START_ELSEWHERE;
    let by_side = if enters {
        side.near > caps.near
    } else {
        side.far < caps.far
    };
    let upwards = dl.z > F::zero();
    CylinderHit {
        t: if start == START_INSIDE {
            max2(far, F::zero())
        } else if !found {
            -F::one()
        } else if enters {
            near
        } else {
            far
        },
        part: if by_side {
            CYLINDER_SIDE
        } else if upwards == enters {
            CYLINDER_BASE
        } else {
            CYLINDER_TOP
        },
    }
}

/// The point that was hit, in the cylinder's frame moved onto the part and within it.
pub fn cylinder_surface<F: Real>(ray: Ray<F>, hit: Hit<F>, cylinder: &Cylinder<F>) -> Surface<F> {
    let frame = cylinder_frame(cylinder);
    let p = to_local(frame, ray.o - cylinder.base + ray.d * hit.t);
    let on_side = hit.prim == CYLINDER_SIDE;
    let on_base = hit.prim == CYLINDER_BASE;
    let rho = (p.x * p.x + p.y * p.y).sqrt();
    // Where the radius is below the resolution of the coordinates, any direction will do.
    let on_axis = rho == F::zero();
    let x = if on_axis { F::one() } else { p.x / rho };
    let y = if on_axis { F::zero() } else { p.y / rho };
    let r = if on_side {
        cylinder.radius
    } else {
        min2(rho, cylinder.radius)
    };
    let cap = if on_base { F::zero() } else { cylinder.height };
    let z = if on_side {
        min2(max2(p.z, F::zero()), cylinder.height)
    } else {
        cap
    };
    let side = to_world(frame, vec3(x, y, F::zero()));
    let n = if on_side {
        side
    } else if on_base {
        -cylinder.w
    } else {
        cylinder.w
    };
    Surface {
        p: cylinder.base + to_world(frame, vec3(x * r, y * r, z)),
        ng: n,
        ns: n,
    }
}

//! Capped cylinders; twin of `shaders/shape/cylinder.glsl`.

use super::ray::{Hit, Ray, Surface, start_on};
use super::slab::{Slab, enters, first_of, slab};
pub use crate::layout::constants::cylinder::{CYLINDER_BASE, CYLINDER_SIDE, CYLINDER_TOP};
use crate::layout::constants::ray::{FAR, PARALLEL, START_INSIDE};
use crate::reference::math::frame::{Frame, to_local};
use crate::reference::math::{Real, Vec3, dot3, max2, min2};
pub use crate::shape::cylinder::scalar::Cylinder;

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

/// The interval of a ray inside the infinite cylinder x² + y² ≤ r², in the cylinder's frame.
///
/// a t² − 2b t + c = 0 with a = dx² + dy², b = −(ox dx + oy dy), c = ρ² − r² = (ρ − r)(ρ + r). The
/// discriminant b² − a c cancels; it equals a r² − (ox dy − oy dx)², which does not. A ray that starts on the
/// side to the inside has the roots 0 and 2b/a.
pub fn side_stretch<F: Real>(o: Vec3<F>, d: Vec3<F>, radius: F, start: u32, part: u32) -> Slab<F> {
    let zero = F::zero();
    let inside = start == START_INSIDE;
    let a = d.x * d.x + d.y * d.y;
    let parallel = a < F::new(PARALLEL);
    let divisor = if parallel { F::one() } else { a };
    let b = -(o.x * d.x + o.y * d.y);
    let rho = (o.x * o.x + o.y * o.y).sqrt();
    let c = (rho - radius) * (rho + radius);
    let cross = o.x * d.y - o.y * d.x;
    let disc = a * (radius * radius) - cross * cross;
    let root = max2(disc, zero).sqrt();
    let q = if b < zero { b - root } else { b + root };
    let on_side = inside && part == CYLINDER_SIDE;
    let t0 = if on_side || q == zero { zero } else { c / q };
    let t1 = if on_side { b + b } else { q } / divisor;
    let crosses = if parallel { rho < radius } else { disc >= zero };
    let within = inside || crosses;
    let far = if within { F::new(FAR) } else { -F::new(FAR) };
    let bounded = within && !parallel;
    Slab {
        near: if bounded { min2(t0, t1) } else { -far },
        far: if bounded { max2(t0, t1) } else { far },
    }
}

/// The first hit with a capped cylinder along the unit vector `d`, or t = −1.
///
/// `start` is the ray's relation to this cylinder, `part` the part that it starts on. If it leaves to the outside:
/// never. To the inside: at the exit, t ≥ 0, always found. From elsewhere: the least t > 0. The solid is the
/// intersection of an infinite cylinder with the space between two planes, and so are the ray's intervals.
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
    let stretch = Slab {
        near: max2(side.near, caps.near),
        far: min2(side.far, caps.far),
    };
    let entering = enters(stretch, start);
    let by_side = if entering {
        side.near > caps.near
    } else {
        side.far < caps.far
    };
    let upwards = dl.z > F::zero();
    CylinderHit {
        t: first_of(stretch, start),
        part: if by_side {
            CYLINDER_SIDE
        } else if upwards == entering {
            CYLINDER_BASE
        } else {
            CYLINDER_TOP
        },
    }
}

/// Whether a ray along `d` goes through a cap from outside; never called for the side, which touches no other solid.
pub fn cap_enters<F: Real>(cylinder: &Cylinder<F>, part: u32, d: Vec3<F>) -> bool {
    let along = dot3(d, cylinder.w);
    match part {
        CYLINDER_BASE => along > F::zero(),
        CYLINDER_TOP => along < F::zero(),
        _ => false,
    }
}

/// The point that was hit, in the cylinder's frame moved onto the part and within it.
pub fn cylinder_surface<F: Real>(ray: Ray<F>, hit: Hit<F>, cylinder: &Cylinder<F>) -> Surface<F> {
    let frame = cylinder_frame(cylinder);
    let p = to_local(frame, ray.o - cylinder.base + ray.d * hit.t);
    let on_side = hit.prim == CYLINDER_SIDE;
    let on_base = hit.prim == CYLINDER_BASE;
    let rho = (p.x * p.x + p.y * p.y).sqrt();
    // If the radius is below the resolution of the coordinates, take the side that faces the ray, or from within the
    // other one; any side if the ray runs along the axis.
    let on_axis = rho == F::zero();
    let leaves = start_on(ray, cylinder.shape) == START_INSIDE;
    let along = to_local(frame, if leaves { ray.d } else { -ray.d });
    let across = (along.x * along.x + along.y * along.y).sqrt();
    let parallel = across == F::zero();
    let ex = if parallel { F::one() } else { along.x / across };
    let ey = if parallel {
        F::zero()
    } else {
        along.y / across
    };
    let divisor = if on_axis { F::one() } else { rho };
    let x = if on_axis { ex } else { p.x / divisor };
    let y = if on_axis { ey } else { p.y / divisor };
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
    let side = frame.t * x + frame.b * y;
    let n = if on_side {
        side
    } else if on_base {
        -cylinder.w
    } else {
        cylinder.w
    };
    Surface {
        p: cylinder.base + (side * r + frame.n * z),
        ng: n,
        ns: n,
    }
}

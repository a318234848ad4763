//! A ray that starts on a mesh, and the hits that are only its origin's rounding error; twin of
//! `shaders/shape/triangle/origin.glsl`.

use super::area::abs3;
use super::{Triangle, TriangleHit};
use crate::reference::math::{Real, Vec3, cross3, dot3, max_component, max2};
use crate::reference::shape::ray::{Ray, START_OUTSIDE};

/// How far rounding may lift a ray's origin off the triangle on which it starts, and the planes of its neighbours away
/// from it, in each coordinate: this many half-ulps of the largest coordinate M involved.
///
/// The origin is v₀ + (u e₁ + v e₂), |e| ≤ 2M: 2 + 2 + 2 for the edges, the products and their sum, 1 for the last sum;
/// 2 for the difference to a corner of the neighbour; and 6 for the neighbour's normal, e₁ × e₂, which multiplies
/// lengths of up to 2M.
const ORIGIN_ERROR: f64 = 16.0;

/// The distance along `d` within which a ray from `p`, on a triangle with normal `ng`, has not risen off that triangle
/// by more than the rounding error of `p`.
pub fn triangle_self_distance<F: Real>(p: Vec3<F>, ng: Vec3<F>, d: Vec3<F>) -> F {
    let error = F::new(ORIGIN_ERROR) * F::ULP * max_component(abs3(p));
    // Along the triangle: almost everywhere, and finite.
    error / max2(dot3(d, ng).abs(), F::new(1e-20))
}

/// Whether a hit is the ray's own origin again, lifted off its mesh by rounding.
///
/// It is if it lies on the same triangle. On another triangle of the same mesh it is if the ray crosses it towards the side to
/// which the ray has already left (a ray to the outside of a closed mesh cannot come out of it first, one to the inside cannot
/// go in) *and* if, up to rounding, the ray is still in the plane in which it started, or also started in the plane of that
/// triangle. A surface that the ray may truly meet first, such as a wall in a corner, therefore stops it at any distance.
pub fn is_origin<F: Real>(
    ray: Ray<F>,
    triangle: &Triangle<F>,
    prim: u32,
    hit: TriangleHit<F>,
) -> bool {
    let [v0, v1, v2] = triangle.v;
    let n = cross3(v1 - v0, v2 - v0);
    let size = max2(
        max2(max_component(abs3(v0)), max_component(abs3(v1))),
        max2(max_component(abs3(v2)), max_component(abs3(ray.o))),
    );
    let sum = abs3(n);
    let error = F::new(ORIGIN_ERROR) * F::ULP * size * (sum.x + sum.y + sum.z);
    let in_plane = hit.t <= ray.t_self || dot3(n, v0 - ray.o).abs() <= error;
    let leaves = hit.back == (ray.start == START_OUTSIDE);
    triangle.shape == ray.shape && (prim == ray.prim || (leaves && in_plane))
}

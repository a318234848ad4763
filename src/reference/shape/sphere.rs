//! Spheres; twin of `shaders/shape/sphere.glsl`.

use super::ray::{Hit, Ray, START_ELSEWHERE, START_INSIDE, Surface, start_on};
use crate::reference::math::{Real, Vec3, dot3, length3, max2, min2};
pub use crate::shape::sphere::scalar::Sphere;

/// Distance to the sphere's surface along the unit vector `d`, or −1.
///
/// `start` is the ray's relation to this sphere. If it leaves to the outside: never. To the inside: |oc| = r makes the
/// roots 0 and −2 oc·d, and the second is the exit, at least 0. From elsewhere: the least t > 0. Haines, Günther,
/// Akenine-Möller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems (2019), chapter 7: the
/// discriminant from the ray's distance to the centre, r² − |oc − (oc·d)d|², and the smaller root as c/q. If both q and
/// c are only rounding errors, for a ray that starts on the sphere and along it, c/q is arbitrary; so it is clamped to
/// within √disc of its true place.
pub fn sphere_hit<F: Real>(o: Vec3<F>, d: Vec3<F>, centre: Vec3<F>, radius: F, start: u32) -> F {
    let none = -F::one();
    let oc = o - centre;
    let b = -dot3(oc, d);
    let l = oc + d * b;
    let disc = radius * radius - dot3(l, l);
    let root = max2(disc, F::zero()).sqrt();
    let q = if b < F::zero() { b - root } else { b + root };
    let distance = length3(oc);
    // t₀ t₁ = c = |oc|² − r², without the cancellation.
    let c = (distance - radius) * (distance + radius);
    let quotient = if q == F::zero() { F::zero() } else { c / q };
    let other = min2(max2(quotient, b - (root + root)), b + (root + root));
    let near = if b < F::zero() { q } else { other };
    let far = if b < F::zero() { other } else { q };
    let ahead = if near > F::zero() { near } else { far };
    let elsewhere = if disc >= F::zero() && ahead > F::zero() {
        ahead
    } else {
        none
    };
    let inside = max2(b + b, F::zero());
    if start == START_ELSEWHERE {
        elsewhere
    } else if start == START_INSIDE {
        inside
    } else {
        none
    }
}

/// The point that was hit, moved along the radius onto the sphere.
pub fn sphere_surface<F: Real>(ray: Ray<F>, hit: Hit<F>, sphere: &Sphere<F>) -> Surface<F> {
    let v = ray.o - sphere.centre + ray.d * hit.t;
    let length = length3(v);
    // If the radius is below the resolution of the coordinates, take the side that faces the ray, or from within the other one.
    let lost = length == F::zero();
    let leaves = start_on(ray, sphere.shape) == START_INSIDE;
    let n = if lost {
        if leaves { ray.d } else { -ray.d }
    } else {
        v / if lost { F::one() } else { length }
    };
    Surface {
        p: sphere.centre + n * sphere.radius,
        ng: n,
        ns: n,
    }
}

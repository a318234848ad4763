//! A ray against boxes, so that no box hides a hit within it.
//!
//! Let u = [`Real::ULP`], R = max |oₖ| + reach, where no box has a coordinate beyond ±reach.
//!
//! * A primitive's own test computes with rounded numbers. What it reports as a hit at t may, taken exactly, miss
//!   the primitive; but o + t d lies within 48 u R of the primitive's box on every axis. For a triangle: each
//!   sheared corner is wrong by 6 u R (difference, shear, product, difference); the weights, positive and
//!   relatively exact to 2 u, and the sums that make t of them add 14 u R along the axis of the shear, and no more
//!   along the others. For a sphere: 10 u R for the foot of the perpendicular on the ray, 7 u R for the roots,
//!   12 u R where the lesser one is found by division. For a cylinder 25 u R, as all is turned into its frame
//!   first; for a box 5 u R.
//! * The plane x of a box is met at (x − o)/d, computed with three roundings after o was moved: as if the plane
//!   stood up to 5 u R elsewhere. The kernels' planes are sums of two products: 10 u R.
//! * A direction's component below u² in size is replaced by ±u², so that nothing is divided by 0: over the
//!   distance of any hit, at most √3 R, it moves the ray by 4 u² R.
//!
//! So boxes grown by [`PAD`]·u·R = 64 u R on each side contain every hit within them, and the computed
//! entry ≤ t ≤ exit. Instead of growing each box, the ray's origin is moved: one way for the planes it meets
//! first, the other way for those it leaves by. `tests/device/bvh/` holds the 48 u R against what the tests report.

use crate::reference::math::{Real, Vec3, max2, min2, vec3};

/// Growth of boxes in units of u·R.
const PAD: f64 = 64.0;

/// What a ray's box tests have in common.
pub struct Slabs<F> {
    /// 1/d
    inverse: Vec3<F>,
    /// The origin moved forward along each axis by the padding, for planes that the ray enters by.
    entering: Vec3<F>,
    /// The origin moved back, for planes that it leaves by.
    leaving: Vec3<F>,
    /// On each axis which of a box's planes the ray enters by: 0, the lower, or 1.
    first: [usize; 3],
}

impl<F: Real> Slabs<F> {
    /// For the ray o + t d and boxes without a coordinate beyond ±`reach`.
    pub fn new(o: Vec3<F>, d: Vec3<F>, reach: F) -> Self {
        let zero = F::zero();
        let largest = max2(max2(o.x.abs(), o.y.abs()), o.z.abs());
        let pad = F::new(PAD) * F::ULP * (largest + reach);
        let tiny = F::ULP * F::ULP;
        let away = |x: F| match (x.abs() < tiny, x < zero) {
            (false, _) => x,
            (true, false) => tiny,
            (true, true) => -tiny,
        };
        let d = vec3(away(d.x), away(d.y), away(d.z));
        let forward = |x: F| if x < zero { -pad } else { pad };
        let shift = vec3(forward(d.x), forward(d.y), forward(d.z));
        Self {
            inverse: Vec3::one() / d,
            entering: o + shift,
            leaving: o - shift,
            first: [d.x, d.y, d.z].map(|x| usize::from(x < zero)),
        }
    }

    /// Where the ray enters the grown box { lo ≤ x ≤ hi }, 0 if it starts within; `None` if it misses it or
    /// enters beyond `t_max`. At `t_max` itself counts: the nearest hit may be one of several at one distance.
    #[inline]
    pub fn entry(&self, lo_hi: &[Vec3<F>; 2], t_max: F) -> Option<F> {
        // `& 1` and the length tell the compiler that no index is out of bounds
        let at = self.first.map(|k| k & 1);
        let plane = |x: usize, y: usize, z: usize| vec3(lo_hi[x].x, lo_hi[y].y, lo_hi[z].z);
        let near = (plane(at[0], at[1], at[2]) - self.entering) * self.inverse;
        let far = (plane(1 - at[0], 1 - at[1], 1 - at[2]) - self.leaving) * self.inverse;
        let entry = max2(max2(near.x, near.y), max2(near.z, F::zero()));
        let exit = min2(min2(far.x, far.y), min2(far.z, t_max));
        (entry <= exit).then_some(entry)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(o: [f64; 3], d: [f64; 3], t_max: f64) -> Option<f64> {
        let v = |a: [f64; 3]| vec3(a[0] as f32, a[1] as f32, a[2] as f32);
        Slabs::new(v(o), v(d), 1.0)
            .entry(&[v([-1.0; 3]), v([1.0; 3])], t_max as f32)
            .map(f64::from)
    }

    #[test]
    fn rays_along_axes_and_faces() {
        let near =
            |t: Option<f64>, expected: f64| t.is_some_and(|t| t <= expected && t > expected - 1e-4);
        for zero in [0.0, -0.0] {
            assert!(near(entry([-3.0, 0.0, 0.0], [1.0, zero, zero], 10.0), 2.0));
            assert!(near(entry([3.0, 0.5, 0.5], [-1.0, zero, zero], 10.0), 2.0));
            // Within a face, within an edge, within a face's plane but beside the face.
            assert!(near(entry([-3.0, 1.0, 0.0], [1.0, zero, zero], 10.0), 2.0));
            assert!(near(entry([-3.0, 1.0, -1.0], [1.0, zero, zero], 10.0), 2.0));
            assert_eq!(entry([-3.0, 1.0, 1.01], [1.0, zero, zero], 10.0), None);
            assert_eq!(entry([3.0, 0.0, 0.0], [1.0, zero, zero], 10.0), None);
        }
        assert_eq!(entry([0.0; 3], [0.6, 0.0, 0.8], 10.0), Some(0.0));
        assert!(entry([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0).is_some());
        assert_eq!(entry([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], 1.9), None);
        assert_eq!(entry([-3.0, 0.0, 0.0], [f64::NAN; 3], 10.0), None);
    }
}

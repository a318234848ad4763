//! Tests a ray against boxes, so that no box hides a hit inside it.
//!
//! Let u = 2⁻²⁴, R = max |oₖ| + reach, where no box has a coordinate beyond ±reach.
//!
//! * A primitive's own test computes with rounded numbers. A hit that it reports at t may, taken exactly, miss the
//!   primitive; but o + t d lies within 48 u R of the primitive's box on every axis. For a triangle: each
//!   sheared corner is wrong by 6 u R (difference, shear, product, difference); the weights, positive and
//!   relatively exact to 2 u, and the sums that give t add 14 u R along the axis of the shear, and no more
//!   along the others. For a sphere: 10 u R for the foot of the perpendicular on the ray, 7 u R for the roots,
//!   12 u R where the lesser one is found by division. For a cylinder 25 u R, as all is rotated into its frame
//!   first; for a box 5 u R.
//! * The plane x of a box is met at (x − o)/d, computed with three roundings after o was moved: as if the plane
//!   were up to 5 u R elsewhere. The kernels' planes are sums of two products: 10 u R.
//! * A direction's component below u² in size is replaced by ±u², so that nothing is divided by 0: over the
//!   distance of any hit, at most √3 R, it moves the ray by 4 u² R.
//! * The ray of an `f64` rendering is rounded to `f32` for its boxes: 1 u R for the origin, 2 u R for the direction.
//!
//! So boxes grown by [`PAD`]·u·R = 64 u R on each side contain every hit within them, and the computed entry ≤ t ≤
//! exit. Instead of growing each box, the ray's origin is moved: one way for the planes through which it enters, the
//! other way for those through which it leaves. `tests/device/bvh/` checks the 48 u R on the tests' own hits.

use wide::f32x8;

use crate::reference::math::{Real, max2};

/// Growth of boxes in units of u·R.
const PAD: f32 = 64.0;

/// The part of a ray's box tests that all boxes share, for [`Node::meet`](super::node::Node::meet).
pub struct Slabs {
    /// 1/d
    pub inverse: [f32x8; 3],
    /// The origin moved forward along each axis by the padding, for planes through which the ray enters.
    pub entering: [f32x8; 3],
    /// The origin moved back, for planes through which it leaves.
    pub leaving: [f32x8; 3],
    /// On each axis, the plane through which the ray enters a box: 0, the lower, or 1.
    pub first: [usize; 3],
}

impl Slabs {
    /// For the ray o + t d and boxes without a coordinate beyond ±`reach`.
    #[inline]
    pub fn new(o: [f32; 3], d: [f32; 3], reach: f32) -> Self {
        let largest = max2(max2(o[0].abs(), o[1].abs()), o[2].abs());
        let pad = PAD * f32::ULP * (largest + reach);
        let tiny = f32::ULP * f32::ULP;
        let away = |x: f32| match (x.abs() < tiny, x < 0.0) {
            (false, _) => x,
            (true, false) => tiny,
            (true, true) => -tiny,
        };
        let d = d.map(away);
        let axes = [0, 1, 2];
        let forward = |k: usize| if d[k] < 0.0 { -pad } else { pad };
        Self {
            inverse: d.map(|x| f32x8::splat(1.0 / x)),
            entering: axes.map(|k| f32x8::splat(o[k] + forward(k))),
            leaving: axes.map(|k| f32x8::splat(o[k] - forward(k))),
            first: d.map(|x| usize::from(x < 0.0)),
        }
    }
}

//! eˣ − 1, accurate near 0.

use super::exp::{exp_reduce, pow2, scale_by_pow2};
use crate::reference::math::{max2, min2};

/// eˣ − 1: −1 below −17.3, ∞ above 88.72.
pub fn expm1(x: f32) -> f32 {
    // Past these ends the result is −1 or ∞.
    let (k, r, q) = exp_reduce(min2(max2(x, -18.0), 89.0));
    // 2ᵏ ((1 − 2⁻ᵏ) + r + q), with the rounding errors of both sums added back. The lower of the
    // two summands of b counts as 0 from k = 30 on: 2^-30 is below any rounding error of 1.
    let p = pow2(-min2(k, 30.0));
    let b = 1.0 - p;
    let h = b + r;
    let lost = ((1.0 - b) - p) + (r - (h - b));
    scale_by_pow2(h + (lost + q), k)
}

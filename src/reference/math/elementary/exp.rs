//! The exponential function, and the reduction that it shares with `expm1`.

use crate::reference::math::{max2, min2};

/// eˣ: denormal results are rounded once, 0 below −103.97, ∞ above 88.72.
pub fn exp(x: f32) -> f32 {
    // Past these ends the result is 0 or ∞; between them k fits `scale_by_pow2`.
    let (k, r, q) = exp_reduce(min2(max2(x, -104.0), 89.0));
    // 1 + r + q, with the rounding error of 1 + r added back
    let h = 1.0 + r;
    scale_by_pow2(h + ((r - (h - 1.0)) + q), k)
}

/// (k, r, q) with eˣ = 2ᵏ (1 + r + q), k whole, |r| ≤ ½ ln 2, |x| ≤ 104.
///
/// x = k ln 2 + r + c, where c is the rounding error of r, and q = e^(r+c) − 1 − r = r² E(r) + c (1 + r), relative
/// error of r + q: 2⁻³⁰·⁹.
pub fn exp_reduce(x: f32) -> (f32, f32, f32) {
    let k = (x * 1.442695 + 0.5).floor();
    // ln 2 in two parts; the first has 15 bits, so that k times it is exact.
    let hi = x - k * 0.69314575;
    let lo = k * 1.4286068e-6;
    let r = hi - lo;
    let c = (hi - r) - lo;
    let e = 0.041666478 + r * (0.0083335675 + r * (0.0013933708 + r * 0.00019742562));
    let q = r * r * (0.5 + r * (0.16666666 + r * e)) + c * (1.0 + r);
    (k, r, q)
}

/// y 2ᵏ for whole k in −254 … 254, in two steps because 2ᵏ alone may be out of range.
pub fn scale_by_pow2(y: f32, k: f32) -> f32 {
    let half = (k * 0.5).floor();
    y * pow2(half) * pow2(k - half)
}

/// 2ᵏ for whole k in −126 … 127.
///
/// k + 127 + 1.5·2²³ has k + 127 in its low bits: shifted, they are the exponent.
pub fn pow2(k: f32) -> f32 {
    f32::from_bits((k + 12583039.0).to_bits() << 23)
}

//! Tests for broken and for black values; twin of `shaders/math/finite.glsl`.

use super::real::Real;
use super::vec::Vec3;

/// Neither NaN nor infinite.
pub fn is_finite<F: Real>(x: F) -> bool {
    !(x.is_nan() || x.is_infinite())
}

/// All three components are finite.
pub fn is_finite3<F: Real>(v: Vec3<F>) -> bool {
    is_finite(v.x) && is_finite(v.y) && is_finite(v.z)
}

/// No component is positive; false if one is NaN, so that NaN is never taken for black.
pub fn is_black<F: Real>(v: Vec3<F>) -> bool {
    let zero = F::zero();
    v.x <= zero && v.y <= zero && v.z <= zero
}

/// Whether a component is not a number.
pub fn has_nan<F: Real>(v: Vec3<F>) -> bool {
    v.x.is_nan() || v.y.is_nan() || v.z.is_nan()
}

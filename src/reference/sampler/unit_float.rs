//! From words to numbers.

use crate::reference::math::Real;

/// The upper 24 bits of `x` as a number in [0, 1 − 2⁻²⁴], exact: x / 2³² would round up to 1.
pub fn unit_float<F: Real>(x: u32) -> F {
    F::from_u32(x >> 8) * F::new(5.960464477539063e-8)
}

//! The project's own elementary functions in `f32`; twins of `shaders/math/elementary/`.
//!
//! Vulkan leaves the accuracy of `sin`, `exp` and `log` to the driver (lavapipe's `log` is 3100 ulp off near 1). These
//! consist of + − × ÷ √, `floor` and bit casts only, in a written-out order, so that every device that rounds correctly
//! returns the same bits. Error bounds, over every `f32` of the domain, in units of the last place of the true value:
//!
//! | function | bound | at the ends |
//! |---|---|---|
//! | [`sincos_2pi`] | 1.4 ulp | exact at multiples of 1/4 |
//! | [`exp`] | 1 ulp | 0 below −103.97, ∞ above 88.72 |
//! | [`expm1`] | 1 ulp | −1 below −17.3, ∞ above 88.72 |
//! | [`log1p`] | 1 ulp | −∞ at −1, NaN below, ∞ at ∞ |
//! | [`erfc`] | 6 ulp | 2 below −3.9, 0 above 10.06 |
//! | [`erfc_inverse`] | 4 ulp | ∞ at 0, −∞ at 2, NaN outside [0, 2] and at −0 |
//! | [`turns`] | 4 ulp | 0 at the origin; below 2¹²⁶ |
//!
//! A NaN yields a NaN. The sign of a zero result is not kept.
//!
//! Polynomials: Remez's exchange (for `erfc` with Lawson's weights) for the relative error of the function,
//! coefficients rounded to `f32` one after the other from the lowest order, the rest fitted again. The reductions
//! follow the FreeBSD msun library (e_expf.c, s_expm1f.c, s_log1pf.c), with compensated sums in place of its divisions.

#![allow(
    clippy::approx_constant,
    reason = "the digits are those of the GLSL twins"
)]

mod erfc;
mod erfc_inverse;
mod exp;
mod expm1;
mod log1p;
mod sincos;
#[cfg(test)]
mod tests;
mod turns;

pub use erfc::{ErfcGauss, erfc, erfc_gauss, exp_minus_square};
pub use erfc_inverse::{erfc_inverse, erfc_inverse_far, erfc_inverse_near};
pub use exp::{exp, exp_reduce, pow2, scale_by_pow2};
pub use expm1::expm1;
pub use log1p::log1p;
pub use sincos::{quadrant, rotate_by_quadrant, sincos_2pi};
pub use turns::{fraction, turns};

//! The reference's scalar type.
//!
//! In `f32` every operation is the one that the kernel performs, in the same order, so that the two agree bit for bit
//! on a device that rounds correctly; in `f64` the same code measures the error of `f32`.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use statrs::function::erf;
use wide::{f32x8, f64x8};

use super::elementary::{self, ErfcGauss};
use super::lanes::Lanes;

/// A floating-point scalar with the operations that the kernels use and no others.
///
/// `+ − × ÷ √` round correctly. The elementary functions are the project's own polynomials in `f32`
/// (twins of `shaders/math/elementary/`), and those of the standard library and of `libm` in `f64`.
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// Eight scalars side by side.
    type Lanes: Lanes<Self> + Debug + Send + Sync + 'static;
    /// Half the distance from 1 to the next larger number: 2⁻²⁴ or 2⁻⁵³.
    const ULP: Self;
    /// The least number of full precision, 2⁻¹²⁶ or 2⁻¹⁰²².
    const LEAST_NORMAL: Self;
    /// 2⁻³² of the scalar's upper limit: 2⁹⁶ or 2⁹⁹².
    const SUMMABLE: Self;
    /// 2^⌈p/2⌉ + 1, which splits a number of p bits into halves: see `products`.
    const SPLIT: Self;
    /// The nearest scalar to `x`.
    fn new(x: f64) -> Self;
    /// The exact value.
    fn f64(self) -> f64;
    /// `k`, exact for `k` < 2²⁴.
    fn from_u32(k: u32) -> Self;
    /// ⌊x⌋ as an integer, for 0 ≤ x < 2³².
    fn to_u32(self) -> u32;
    /// √x, correctly rounded; NaN below 0.
    fn sqrt(self) -> Self;
    /// |x|
    fn abs(self) -> Self;
    /// ⌊x⌋, the largest whole number that is not above x.
    fn floor(self) -> Self;
    /// Not a number.
    fn is_nan(self) -> bool;
    /// ∞ or −∞.
    fn is_infinite(self) -> bool;
    /// (sin 2πu, cos 2πu) for u in [0, 1], exact at multiples of 1/4.
    fn sincos_2pi(u: Self) -> (Self, Self);
    /// The angle of (x, y) from the x axis, in turns, from −1/2 to 1/2: 0 at the origin.
    fn turns(y: Self, x: Self) -> Self;
    /// eˣ
    fn exp(x: Self) -> Self;
    /// eˣ − 1, accurate near 0.
    fn expm1(x: Self) -> Self;
    /// ln(1 + x), accurate near 0; −∞ at −1, NaN below.
    fn log1p(x: Self) -> Self;
    /// 1 − erf x, accurate where erf x is near 1.
    fn erfc(x: Self) -> Self;
    /// 1 − erf x and e^(−x²).
    fn erfc_gauss(x: Self) -> ErfcGauss<Self>;
    /// The x with erfc x = z; ∞ at 0, −∞ at 2, NaN outside and at −0.
    fn erfc_inverse(z: Self) -> Self;

    /// 0
    fn zero() -> Self {
        Self::new(0.0)
    }
    /// 1
    fn one() -> Self {
        Self::new(1.0)
    }
}

macro_rules! common {
    ($t:ty) => {
        fn new(x: f64) -> Self {
            x as $t
        }
        fn f64(self) -> f64 {
            self as f64
        }
        fn from_u32(k: u32) -> Self {
            k as $t
        }
        fn to_u32(self) -> u32 {
            self as u32
        }
        fn sqrt(self) -> Self {
            <$t>::sqrt(self)
        }
        fn abs(self) -> Self {
            <$t>::abs(self)
        }
        fn floor(self) -> Self {
            <$t>::floor(self)
        }
        fn is_nan(self) -> bool {
            <$t>::is_nan(self)
        }
        fn is_infinite(self) -> bool {
            <$t>::is_infinite(self)
        }
    };
}

impl Real for f32 {
    type Lanes = f32x8;
    const ULP: Self = f32::EPSILON / 2.0;
    const LEAST_NORMAL: Self = f32::MIN_POSITIVE;
    const SUMMABLE: Self = 79_228_162_514_264_337_593_543_950_336.0;
    const SPLIT: Self = 4097.0;
    common!(f32);
    fn sincos_2pi(u: Self) -> (Self, Self) {
        elementary::sincos_2pi(u)
    }
    fn turns(y: Self, x: Self) -> Self {
        elementary::turns(y, x)
    }
    fn exp(x: Self) -> Self {
        elementary::exp(x)
    }
    fn expm1(x: Self) -> Self {
        elementary::expm1(x)
    }
    fn log1p(x: Self) -> Self {
        elementary::log1p(x)
    }
    fn erfc(x: Self) -> Self {
        elementary::erfc(x)
    }
    fn erfc_gauss(x: Self) -> ErfcGauss<Self> {
        elementary::erfc_gauss(x)
    }
    fn erfc_inverse(z: Self) -> Self {
        elementary::erfc_inverse(z)
    }
}

impl Real for f64 {
    type Lanes = f64x8;
    const ULP: Self = f64::EPSILON / 2.0;
    const LEAST_NORMAL: Self = f64::MIN_POSITIVE;
    const SUMMABLE: Self = f64::MAX / 4_294_967_296.0;
    const SPLIT: Self = 134_217_729.0;
    common!(f64);
    fn sincos_2pi(u: Self) -> (Self, Self) {
        let (k, r) = elementary::quadrant(u);
        let (sin_r, cos_r) = (r * std::f64::consts::FRAC_PI_2).sin_cos();
        elementary::rotate_by_quadrant(k, sin_r, cos_r)
    }
    fn turns(y: Self, x: Self) -> Self {
        y.atan2(x) / std::f64::consts::TAU
    }
    fn exp(x: Self) -> Self {
        f64::exp(x)
    }
    fn expm1(x: Self) -> Self {
        f64::exp_m1(x)
    }
    fn log1p(x: Self) -> Self {
        f64::ln_1p(x)
    }
    fn erfc(x: Self) -> Self {
        libm::erfc(x)
    }
    fn erfc_gauss(x: Self) -> ErfcGauss<Self> {
        ErfcGauss {
            erfc: libm::erfc(x),
            gauss: f64::exp(-x * x),
        }
    }
    fn erfc_inverse(z: Self) -> Self {
        if z.is_sign_negative() || z > 2.0 {
            f64::NAN
        } else {
            erf::erfc_inv(z)
        }
    }
}

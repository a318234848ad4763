//! The complement of the error function, which resolves small values where erf rounds to 1.

use super::exp::exp;
use crate::reference::math::products::{halves, product_error};
use crate::reference::math::{max2, min2};

/// erfc x, and the e^(−x²) of which it is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErfcGauss<F> {
    pub erfc: F,
    pub gauss: F,
}

/// erfc x = 2/√π ∫ₓ^∞ e^(−t²) dt: 2 below −3.9, denormal from 9.19 on, 0 above 10.06.
pub fn erfc(x: f32) -> f32 {
    erfc_gauss(x).erfc
}

/// erfc x and e^(−x²).
pub fn erfc_gauss(x: f32) -> ErfcGauss<f32> {
    // erf x = x S(x²), |x| ≤ ½, relative error 2⁻²⁸
    let s = x * x;
    let small =
        1.1283791 + s * (-0.3761229 + s * (0.11278182 + s * (-0.026508145 + s * 0.0042732772)));
    // erfc a = e^(−a²) t E(t), t = 1/(1 + a/2), a ≥ ½, relative error 2⁻²⁵·⁸. Past 11 both results are 0.
    let a = min2(max2(x, -x), 11.0);
    let t = 1.0 / (1.0 + 0.5 * a);
    let r = t - 0.5;
    let high =
        -0.1719462 + r * (-0.10359114 + r * (0.09602483 + r * (0.05179929 + r * -0.06019629)));
    let e = 0.51079136 + r * (0.6871607 + r * (0.55894154 + r * (0.14576854 + r * high)));
    let gauss = exp_minus_square(a);
    let tail = gauss * (t * e);
    let large = if x < 0.0 { 2.0 - tail } else { tail };
    let erfc = if a <= 0.5 { 1.0 - x * small } else { large };
    ErfcGauss { erfc, gauss }
}

/// e^(−x²) for |x| ≤ 11, with the rounding error of the square, which alone would cost x² ulps.
pub fn exp_minus_square(x: f32) -> f32 {
    let square = x * x;
    let half = halves(x);
    let lost = product_error(half, half, square);
    let e = exp(-square);
    e - e * lost
}

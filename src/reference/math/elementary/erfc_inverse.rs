//! The inverse of `erfc`, which keeps the digits of either tail.

use super::log1p::log1p;

/// The x with erfc x = `z`: ∞ at 0, −∞ at 2, NaN outside [0, 2] and at −0.
///
/// With y = 1 − z = erf x, w = −ln(1 − y²) = −ln(z (2 − z)) and s = √w: x = y M(w) up to w = 5, relative error 2⁻²⁴·⁶,
/// and x = ±s T(1/s) beyond, relative error 2⁻²⁴·³. The form is that of Giles, Approximating the Erfinv Function, GPU
/// Computing Gems 2, 2011; the polynomials are not.
pub fn erfc_inverse(z: f32) -> f32 {
    let y = 1.0 - z;
    // z or 2 − z, which is exact
    let least = if y < 0.0 { 2.0 - z } else { z };
    // 1/z of a denormal z is ∞: 2⁻⁶⁴ is taken out.
    let tiny = least < 5.421011e-20;
    let scaled = if tiny { least * 1.8446744e19 } else { least };
    // y² has lost 1 − y² near the ends, and 1/(z (2 − z)) − 1 has lost y² in the middle.
    let middle = least > 0.5;
    let argument = if middle {
        -(y * y)
    } else {
        1.0 / (scaled * (2.0 - least)) - 1.0
    };
    let l = log1p(argument);
    let w = if middle { -l } else { l } + if tiny { 44.36142 } else { 0.0 };
    let s = w.sqrt();
    let x = if w <= 5.0 {
        y * erfc_inverse_near(w)
    } else {
        s * erfc_inverse_far(s)
    };
    let with_sign = if w > 5.0 && y < 0.0 { -x } else { x };
    // a NaN
    if least < 0.0 { least.sqrt() } else { with_sign }
}

/// M(w), 0 ≤ w ≤ 5.
pub fn erfc_inverse_near(w: f32) -> f32 {
    let v = w - 2.5;
    let highest = -3.5236558e-6 + v * (4.5993565e-7 + v * (2.818565e-8 + v * -8.234456e-9));
    let high = 0.00021857738 + v * (-4.9434735e-6 + v * highest);
    1.5014094 + v * (0.24664028 + v * (-0.0041776686 + v * (-0.0012527556 + v * high)))
}

/// T(1/s), s ≥ √5.
pub fn erfc_inverse_far(s: f32) -> f32 {
    let v = 1.0 / s - 0.25;
    let high = -0.8650434 + v * (0.7420314 + v * (-3.9445274 + v * (5.177823 + v * 3.975362)));
    0.9599459 + v * (-0.19819804 + v * (0.08018991 + v * (0.5546486 + v * high)))
}

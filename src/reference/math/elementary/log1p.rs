//! ln(1 + x), accurate near 0.

/// ln(1 + x): −∞ at −1, NaN below, ∞ at ∞.
pub fn log1p(x: f32) -> f32 {
    // 1 + x = u + delta: u rounded, delta exact (Fast2Sum, the larger summand first)
    let u = 1.0 + x;
    let delta = if x > 1.0 {
        1.0 - (u - x)
    } else {
        x - (u - 1.0)
    };
    // u = 2ᵏ (1 + f), √½ ≤ 1 + f < √2: the constant takes the bits of √½ to those of 1, where the exponent changes.
    let bits = u.to_bits().wrapping_add(0x004a_fb0d);
    let k = ((bits >> 23) as i32 - 127) as f32;
    let f = f32::from_bits((bits & 0x007f_ffff) + 0x3f35_04f3) - 1.0;
    // ln(1 + f) = f + q, q = f² (f L(f) − ½), relative error 2⁻³⁰
    let l = -0.16667323
        + f * (0.14220013
            + f * (-0.12417663 + f * (0.118970476 + f * (-0.11608052 + f * 0.06645262))));
    let q = f * f * (f * (0.33333313 + f * (-0.2500002 + f * (0.20002067 + f * l))) - 0.5);
    // ln(1 + x) = k ln 2 + f + q + delta/u; ln 2 in two parts, the rounding error of the first sum added back.
    let hi = k * 0.69314575;
    let h = hi + f;
    let y = h + ((f - (h - hi)) + (q + (k * 1.4286068e-6 + delta / u)));
    // −1/√u is −∞ for u = 0 and NaN below it.
    let finite = if u > 0.0 { y } else { -1.0 / u.sqrt() };
    if u > 3.4028235e38 { u } else { finite }
}

//! Sweeps over the bits of `f32`, compared with the same functions in f64 (the C library's, below 1 ulp of f64; those
//! that it lacks, with tables).

use super::{erfc, erfc_inverse, exp, exp_minus_square, expm1, log1p, sincos_2pi, turns};
use crate::reference::math::{Real, ulps};

/// Sum of the rounding errors: sine ½ (last sum) + 0.36 (r (π/2 − 1)) + 0.36 (second sum) + 0.07 (polynomial),
/// cosine ½ + ½ (product) + ⅛ (z).
const SIN_COS_BOUND: f64 = 1.4;
/// ½ for the last sum; with compensated sums the rest is that of the small term q, below ½.
const BOUND: f64 = 1.0;
/// ½ for the product, 1½ for the exponential of the square, and 2½ for the effect on E(t) of an error of t, of 1½.
const ERFC_BOUND: f64 = 6.0;
/// ½ for the product, 1 for ln, and 1½ for the effect of both on the polynomial and its own rounding.
const ERFC_INVERSE_BOUND: f64 = 4.0;

/// For t, one for the quotient and ½ each for its parts, one for 1/2π t, ½ for the smaller sum and ½ for the larger;
/// subtracting from ¼ and ½ does not make that larger.
const TURNS_BOUND: f64 = 4.0;

/// The argument with the largest error over every `stride`-th pattern of bits in `bits`.
fn worst(
    bits: std::ops::RangeInclusive<u32>,
    stride: usize,
    error: impl Fn(f32) -> f64,
) -> (f32, f64) {
    let mut worst = (0.0, 0.0);
    for x in bits.step_by(stride).map(f32::from_bits) {
        let e = error(x);
        if e > worst.1 {
            worst = (x, e);
        }
    }
    worst
}

/// sin 2πu and cos 2πu in f64, reduced exactly: u − k/2 has no rounding error.
fn sin_cos_f64(u: f32) -> (f64, f64) {
    let u = f64::from(u);
    let near_sin = (2.0 * u).round();
    let near_cos = (2.0 * u - 0.5).round();
    let sign = |n: f64| if n.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
    let s = sign(near_sin) * ((u - near_sin / 2.0) * std::f64::consts::TAU).sin();
    let c = -sign(near_cos) * ((u - 0.25 - near_cos / 2.0) * std::f64::consts::TAU).sin();
    (s, c)
}

fn sincos_error(u: f32) -> f64 {
    let (s, c) = sincos_2pi(u);
    let (s64, c64) = sin_cos_f64(u);
    ulps(s, s64).max(ulps(c, c64))
}

/// The error at the point (s, s t), its coordinates exchanged for an even k; 0 where a coordinate is beyond the domain.
fn turns_error(t: f32, s: f32, k: u32) -> f64 {
    let st = s * t;
    if st.is_nan() || st.abs() >= 8e37 {
        return 0.0;
    }
    let (y, x) = if k % 2 == 1 { (st, s) } else { (s, st) };
    let truth = f64::from(y).atan2(f64::from(x)) / std::f64::consts::TAU;
    // Below the least normal number a quotient has lost digits.
    match truth.abs() < f64::from(f32::MIN_POSITIVE) {
        true => 0.0,
        false => ulps(turns(y, x), truth),
    }
}

fn sweep(stride: usize) {
    let (u, e) = worst(0..=1f32.to_bits(), stride, sincos_error);
    assert!(e <= SIN_COS_BOUND, "sincos_2pi({u:e}) is {e} ulp off");
    type Row = (&'static str, fn(f32) -> f32, fn(f64) -> f64, f64);
    let all: [Row; 5] = [
        ("exp", exp, f64::exp, BOUND),
        ("expm1", expm1, f64::exp_m1, BOUND),
        ("log1p", log1p, f64::ln_1p, BOUND),
        ("erfc", erfc, <f64 as Real>::erfc, ERFC_BOUND),
        (
            "erfc_inverse",
            erfc_inverse,
            <f64 as Real>::erfc_inverse,
            ERFC_INVERSE_BOUND,
        ),
    ];
    for (name, f, truth, bound) in all {
        let (x, e) = worst(0..=u32::MAX, stride, |x| ulps(f(x), truth(f64::from(x))));
        assert!(e <= bound, "{name}({x:e}) is {e} ulp off");
    }
    for (k, scale) in [(1, 1.0), (2, -1.0), (3, 1e-30), (4, 1e30)] {
        let (t, e) = worst(0..=u32::MAX, stride, |t| turns_error(t, scale, k));
        assert!(
            e <= TURNS_BOUND,
            "turns of {t:e} times {scale:e}, {k} is {e} ulp off"
        );
    }
    let square = |x: f32| ulps(exp_minus_square(x), (-(f64::from(x) * f64::from(x))).exp());
    let (x, e) = worst(0..=11f32.to_bits(), stride, square);
    assert!(e <= 1.5, "exp_minus_square({x:e}) is {e} ulp off");
}

/// Values of mpmath 1.3.0 with 40 and 340 digits.
#[test]
fn erfc_and_its_inverse_are_right_in_f64() {
    let erfc = [
        (-2.5, 1.999_593_047_982_555),
        (-0.3, 1.328_626_759_459_127_4),
        (1e-10, 0.999_999_999_887_162_1),
        (0.3, 0.671_373_240_540_872_6),
        (1.0, 0.157_299_207_050_285_13),
        (2.5, 4.069_520_174_449_589e-4),
        (6.0, 2.151_973_671_249_891_3e-17),
        (26.0, 5.663_192_408_856_143e-296),
    ];
    let inverse = [
        (1e-300, 26.209_469_960_516_124),
        (1e-30, 8.148_616_223_169_865),
        (1e-9, 4.320_005_384_913_445),
        (0.003, 2.098_507_611_793_671),
        (0.2, 0.906_193_802_436_823_2),
        (0.75, 0.225_312_055_012_178_1),
        (1.0625, -0.055_445_948_772_782_02),
        (1.9, -1.163_087_153_676_673_8),
        (1.999_999_999_999_090_5, -5.051_254_085_249_39),
    ];
    let off = |found: f64, truth: f64| (found / truth - 1.0).abs();
    for (x, y) in erfc {
        let found = <f64 as Real>::erfc(x);
        assert!(off(found, y) < 1e-15, "erfc {x}: {found}");
        assert!(off(found, y * (1.0 + 1e-14)) > 1e-15);
    }
    for (z, x) in inverse {
        let found = <f64 as Real>::erfc_inverse(z);
        assert!(off(found, x) < 2e-15, "inverse at {z}: {found}");
    }
}

#[test]
fn errors_stay_in_their_bounds() {
    sweep(997);
}

#[test]
#[ignore = "every f32: minutes"]
fn errors_stay_in_their_bounds_for_every_f32() {
    sweep(1);
}

#[test]
fn the_comparison_sees_two_units_and_a_wrong_end() {
    let planted = |x: f32| f32::from_bits(exp(x).to_bits() + 2);
    let (_, e) = worst(0x3f00_0000..=0x4080_0000, 997, |x| {
        ulps(planted(x), f64::from(x).exp())
    });
    assert!(e > BOUND);
    assert!(ulps(f32::MAX, 89f64.exp()) > BOUND);
}

#[test]
fn quarter_turns_are_exact() {
    let at = [
        (0.0, 0.0, 1.0),
        (0.25, 1.0, 0.0),
        (0.5, 0.0, -1.0),
        (0.75, -1.0, 0.0),
        (1.0, 0.0, 1.0),
    ];
    for (u, s, c) in at {
        assert_eq!(sincos_2pi(u), (s, c));
        assert_eq!(
            <f64 as Real>::sincos_2pi(f64::from(u)),
            (f64::from(s), f64::from(c))
        );
    }
}

#[test]
fn eighths_of_a_turn_are_exact() {
    let at = [
        (0.0, 1.0, 0.0),
        (1.0, 1.0, 0.125),
        (1.0, 0.0, 0.25),
        (1.0, -1.0, 0.375),
        (0.0, -1.0, 0.5),
        (-1.0, -1.0, -0.375),
        (-1.0, 0.0, -0.25),
        (-3.0, 3.0, -0.125),
        (0.0, 0.0, 0.0),
    ];
    for (y, x, turn) in at {
        assert_eq!(turns(y, x), turn);
        assert_eq!(
            <f64 as Real>::turns(f64::from(y), f64::from(x)),
            f64::from(turn)
        );
    }
    assert!(
        ulps(
            turns(0.3, -0.7),
            0.3f64.atan2(-0.7001) / std::f64::consts::TAU
        ) > TURNS_BOUND
    );
}

#[test]
fn ends_of_the_domains_agree_with_the_table() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    assert_eq!([exp(-inf), exp(0.0), exp(inf)], [0.0, 1.0, inf]);
    assert_eq!([expm1(-inf), expm1(0.0), expm1(inf)], [-1.0, 0.0, inf]);
    assert_eq!([log1p(-1.0), log1p(0.0), log1p(inf)], [-inf, 0.0, inf]);
    assert_eq!([erfc(-inf), erfc(0.0), erfc(inf)], [2.0, 1.0, 0.0]);
    let inverses = [erfc_inverse(0.0), erfc_inverse(1.0), erfc_inverse(2.0)];
    assert_eq!(inverses, [inf, 0.0, -inf]);
    let outside = [-0.0, -1e-45, -1e-30, -1.0, 2.000_000_2, inf].map(erfc_inverse);
    for y in [exp(nan), expm1(nan), log1p(nan), log1p(-1.5), log1p(-inf)] {
        assert!(y.is_nan());
    }
    for y in outside.into_iter().chain([erfc(nan), erfc_inverse(nan)]) {
        assert!(y.is_nan());
    }
    // the smallest denormal passes through the two that are x + … near 0
    let tiny = f32::from_bits(1);
    assert_eq!(
        [expm1(tiny), log1p(tiny), expm1(-tiny)],
        [tiny, tiny, -tiny]
    );
}

//! The basis of all twins: arithmetic, comparisons and conversions as in IEEE 754, and none of it
//! rewritten. Each body tempts a compiler: to fuse, to reassociate, to drop a zero, to turn `!(a < b)` into `a >= b`.

#![allow(
    clippy::eq_op,
    clippy::neg_cmp_op_on_partial_ord,
    clippy::neg_multiply,
    clippy::nonminimal_bool,
    reason = "what a compiler might simplify is the point"
)]

use super::harness::{In, Out, Rng, Row, Twin};

/// Zeros, denormals, ends of the range, neighbours of 1, infinities, NaN.
const EDGES: [u32; 16] = [
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x807f_ffff,
    0x0080_0000,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3f80_0001,
    0xbf80_0000,
    0x4b80_0001,
    0x7f7f_ffff,
    0xff7f_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0xffc0_0000,
];

/// Three numbers, of any bits or of like size, and a zero.
fn numbers(r: &mut Rng) -> Row {
    let mut number = || {
        if r.bool() {
            return r.finite();
        }
        let size = r.log_range(0.1, 10.0);
        if r.bool() { size } else { -size }
    };
    Row::new().f(number()).f(number()).f(number()).f(0.0)
}

fn twin(
    name: &'static str,
    glsl: &'static str,
    rust: impl Fn(&mut In, &mut Out) + 'static,
) -> Twin {
    let pairs = EDGES
        .iter()
        .flat_map(|a| EDGES.iter().map(move |b| (*a, *b)));
    let edges = pairs.map(|(a, b)| Row::from([a, b, a ^ b, 0]));
    Twin::new(name, "nothing")
        .source("nothing", "")
        .glsl(&format!(
            "float a = in_f(); float b = in_f(); float c = in_f(); float zero = in_f();\n{glsl}"
        ))
        .rust(rust)
        .edges(edges)
        .seeded(20_000, numbers)
}

fn abc(i: &mut In) -> (f32, f32, f32) {
    let abc = (i.f(), i.f(), i.f());
    assert_eq!(i.u(), 0);
    abc
}

pub fn twins() -> Vec<Twin> {
    vec![
        rounding(),
        contraction(),
        algebra(),
        zeros(),
        comparisons(),
        choices(),
        conversions(),
    ]
}

/// Each operation rounds to nearest, denormals kept.
fn rounding() -> Twin {
    let glsl = "out_f(a + b); out_f(a - b); out_f(a * b); out_f(a / b); out_f(sqrt(a)); out_f(1.0 / sqrt(b));
        out_f(abs(a)); out_f(floor(a)); out_f(-a);
        vec3 v = vec3(a, b, c) * b; out_vec3(v); out_vec3(vec3(a, b, c) / b);";
    twin("rounding", glsl, |i, o| {
        let (a, b, c) = abc(i);
        let results = [
            a + b,
            a - b,
            a * b,
            a / b,
            a.sqrt(),
            1.0 / b.sqrt(),
            a.abs(),
            a.floor(),
            -a,
        ];
        results.into_iter().for_each(|x| o.f(x));
        [a * b, b * b, c * b, a / b, b / b, c / b]
            .into_iter()
            .for_each(|x| o.f(x));
    })
}

/// No product is fused into a sum.
fn contraction() -> Twin {
    let glsl =
        "out_f(a * b + c); out_f(c - a * b); out_f(a * b - c * c); out_f(a * a + b * b + c * c);";
    twin("contraction", glsl, |i, o| {
        let (a, b, c) = abc(i);
        [a * b + c, c - a * b, a * b - c * c, a * a + b * b + c * c]
            .into_iter()
            .for_each(|x| o.f(x));
    })
}

/// Rewrites that real numbers would allow, and floats do not.
fn algebra() -> Twin {
    let glsl = "out_f((a + b) - a); out_f((a - b) + b); out_f((a + b) + c); out_f(a + (b + c)); out_f(a * b * c);
        out_f(a * (b * c)); out_f(a * b / b); out_f(a / b / c); out_f(a / a); out_f(a - a); out_f(a * b + a * c);
        out_f(a / 3.0); out_f(1.0 / (1.0 / a)); out_f(sqrt(a) * sqrt(a)); out_f(sqrt(a * a)); out_f((1.0 - a) * (1.0 + a));";
    twin("algebra", glsl, |i, o| {
        let (a, b, c) = abc(i);
        o.f((a + b) - a);
        o.f((a - b) + b);
        o.f((a + b) + c);
        o.f(a + (b + c));
        o.f(a * b * c);
        o.f(a * (b * c));
        o.f(a * b / b);
        o.f(a / b / c);
        o.f(a / a);
        o.f(a - a);
        o.f(a * b + a * c);
        o.f(a / 3.0);
        o.f(1.0 / (1.0 / a));
        o.f(a.sqrt() * a.sqrt());
        o.f((a * a).sqrt());
        o.f((1.0 - a) * (1.0 + a));
    })
}

/// Zeros keep their sign, and 0·∞ is no zero.
///
/// Not so the literal: lavapipe (its gallivm, 22.3 and 25.0 alike, `NoContraction` or not) makes `a + 0.0` and `0.0 + a`
/// a, `0.0 - a` −a, `a * 0.0` and `0.0 / a` 0 for any a. Where the sign of a zero or a NaN matters, a kernel must not
/// add, multiply or divide by a zero that the compiler can see.
fn zeros() -> Twin {
    let glsl = "out_f(a + zero); out_f(a - zero); out_f(zero - a); out_f(a * zero); out_f(zero / a); out_f(-(-a));
        out_f(-(a - b)); out_f(-(a * b)); out_f(a * 1.0); out_f(a * -1.0); out_f(a / 1.0);";
    twin("zeros", glsl, |i, o| {
        let (a, b, _) = abc(i);
        o.f(a + 0.0);
        o.f(a - 0.0);
        o.f(0.0 - a);
        o.f(a * 0.0);
        o.f(0.0 / a);
        o.f(-(-a));
        o.f(-(a - b));
        o.f(-(a * b));
        o.f(a * 1.0);
        o.f(a * -1.0);
        o.f(a / 1.0);
    })
}

/// Nothing compares with NaN; `!(a < b)` is not `a >= b`. `a != a` is omitted: naga makes it false for NaN, write isnan.
fn comparisons() -> Twin {
    let glsl = "out_b(a < b); out_b(a <= b); out_b(a > b); out_b(a >= b); out_b(a == b);
        out_b(!(a < b)); out_b(!(a <= b)); out_b(!(a > 0.0)); out_b(!(a >= 0.0)); out_b(isnan(a)); out_b(isinf(a));
        out_b(a * b > c); out_b(!(a * b > c)); out_b(a - b < 0.0); out_b(a + b == 0.0);";
    twin("comparisons", glsl, |i, o| {
        let (a, b, c) = abc(i);
        [
            a < b,
            a <= b,
            a > b,
            a >= b,
            a == b,
            !(a < b),
            !(a <= b),
            !(a > 0.0),
            !(a >= 0.0),
        ]
        .into_iter()
        .for_each(|x| o.b(x));
        [
            a.is_nan(),
            a.is_infinite(),
            a * b > c,
            !(a * b > c),
            a - b < 0.0,
            a + b == 0.0,
        ]
        .into_iter()
        .for_each(|x| o.b(x));
    })
}

/// `?:` takes the side that it says, NaN and zeros of two signs included: it is no min or max.
fn choices() -> Twin {
    let glsl = "out_f(b < a ? b : a); out_f(a < b ? b : a); out_f(a > 0.0 ? a : 0.0); out_f(a < 0.0 ? -a : a);
        out_f(!(a > b) ? b : a); out_f(a < b ? a : b); out_f(a >= b ? a : b); out_f(a == 0.0 ? 0.0 : a);";
    twin("choices", glsl, |i, o| {
        let (a, b, _) = abc(i);
        o.f(if b < a { b } else { a });
        o.f(if a < b { b } else { a });
        o.f(if a > 0.0 { a } else { 0.0 });
        o.f(if a < 0.0 { -a } else { a });
        o.f(if !(a > b) { b } else { a });
        o.f(if a < b { a } else { b });
        o.f(if a >= b { a } else { b });
        o.f(if a == 0.0 { 0.0 } else { a });
    })
}

/// Integers to floats round to nearest; floats to integers cut off, within the integers' range.
fn conversions() -> Twin {
    let glsl = "uint u = floatBitsToUint(a); float x = abs(b) < 4.0e9 ? abs(b) : 0.0;
        out_f(float(u)); out_u(uint(x)); out_f(float(int(u))); out_f(float(u >> 8) * 5.9604645e-8);";
    twin("conversions", glsl, |i, o| {
        let (a, b, _) = abc(i);
        let u = a.to_bits();
        let x = if b.abs() < 4.0e9 { b.abs() } else { 0.0 };
        o.f(u as f32);
        o.u(x as u32);
        o.f(u as i32 as f32);
        o.f((u >> 8) as f32 * 2f32.powi(-24));
    })
}

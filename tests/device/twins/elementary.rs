//! Twins of `shaders/math/elementary/`.

use vkpt::reference::math::elementary::{
    erfc, erfc_gauss, erfc_inverse, erfc_inverse_far, erfc_inverse_near, exp, exp_minus_square,
    exp_reduce, expm1, log1p, pow2, quadrant, rotate_by_quadrant, scale_by_pow2, sincos_2pi, turns,
};
use vkpt::reference::math::vec3;

use super::harness::{Row, Twin};
use super::math::SPECIAL;

pub fn twins() -> Vec<Twin> {
    let mut twins = angles();
    twins.extend(exponentials());
    twins.extend(error_functions());
    twins
}

/// Multiples of 1/8 and their neighbours, in [0, 1].
fn eighths() -> impl Iterator<Item = Row> {
    let near = |u: f32| [u.next_down(), u, u.next_up()];
    (0..=8)
        .flat_map(move |k| near(k as f32 / 8.0))
        .filter(|u| (0.0..=1.0).contains(u))
        .map(|u| Row::from([u]))
}

fn angles() -> Vec<Twin> {
    let file = "math/elementary/sincos";
    let fractions = |t: Twin| {
        t.edges(eighths())
            .seeded(20_000, |r| Row::new().f(r.unit()))
    };
    vec![
        fractions(
            Twin::new("sincos_2pi", file)
                .glsl("out_vec2(sincos_2pi(in_f()));")
                .rust(|i, o| o.vec2(sincos_2pi(i.f()).into())),
        )
        .seeded(2000, |r| Row::new().f(r.log_range(1e-38, 1.0))),
        fractions(
            Twin::new("quadrant", file)
                .glsl("out_vec2(quadrant(in_f()));")
                .rust(|i, o| o.vec2(quadrant(i.f()).into())),
        ),
        Twin::new("turns", "math/elementary/turns")
            .also(&["fraction"])
            .glsl("float y = in_f(); out_f(turns(y, in_f()));")
            .rust(|i, o| {
                let y = i.f();
                o.f(turns(y, i.f()));
            })
            .edges(signs())
            .seeded(20_000, |r| {
                Row::new().f(r.range(-1.0, 1.0)).f(r.range(-1.0, 1.0))
            })
            .seeded(2000, |r| {
                Row::new()
                    .f(r.log_range(1e-38, 1e37))
                    .f(r.log_range(1e-38, 1e37))
            }),
        Twin::new("rotate_by_quadrant", file)
            .glsl("float k = in_f(); float s = in_f(); out_vec2(rotate_by_quadrant(k, s, in_f()));")
            .rust(|i, o| o.vec2(rotate_by_quadrant(i.f(), i.f(), i.f()).into()))
            .edges((0..5).map(|k| Row::from([k as f32, 0.0, 1.0])))
            .seeded(100, |r| {
                Row::new()
                    .f(r.below(5) as f32)
                    .f(r.range(-1.0, 1.0))
                    .f(r.unit())
            }),
    ]
}

/// On the axes and between them, with zeros of both signs.
fn signs() -> impl Iterator<Item = Row> {
    const ENDS: [f32; 7] = [-1.0, -1e-30, -0.0, 0.0, 1e-30, 0.5, 1.0];
    ENDS.into_iter()
        .flat_map(|y| ENDS.map(|x| Row::from([y, x])))
}

/// Ends of the ranges of exp, expm1 and log1p, and their neighbours.
fn ends() -> impl Iterator<Item = f32> {
    let ends = [
        -104.0,
        -103.972_08,
        -103.278_93,
        -87.336_54,
        -17.328_68,
        -0.346_573_6,
        0.346_573_6,
        88.722_84,
        89.0,
        -0.292_893_23,
        0.414_213_57,
    ];
    ends.into_iter()
        .flat_map(|x: f32| [x.next_down(), x, x.next_up()])
        .chain(SPECIAL)
}

fn unary(name: &'static str, file: &'static str, f: fn(f32) -> f32) -> Twin {
    Twin::new(name, file)
        .glsl(&format!("out_f({name}(in_f()));"))
        .rust(move |i, o| o.f(f(i.f())))
        .edges(ends().map(|x| Row::from([x])))
        .seeded(20_000, |r| Row::new().u(r.u32()))
        .seeded(20_000, |r| Row::new().f(r.range(-110.0, 95.0)))
        .seeded(20_000, |r| Row::new().f(r.range(-1.0, 1.0)))
}

fn exponentials() -> Vec<Twin> {
    let file = "math/elementary/exp";
    vec![
        unary("exp", file, exp),
        unary("expm1", "math/elementary/expm1", expm1),
        unary("log1p", "math/elementary/log1p", log1p),
        Twin::new("exp_reduce", file)
            .glsl("out_vec3(exp_reduce(in_f()));")
            .rust(|i, o| {
                let (k, r, q) = exp_reduce(i.f());
                o.vec3(vec3(k, r, q));
            })
            .edges(ends().filter(|x| x.abs() <= 104.0).map(|x| Row::from([x])))
            .seeded(5000, |r| Row::new().f(r.range(-104.0, 89.0))),
        Twin::new("pow2", file)
            .glsl("out_f(pow2(in_f()));")
            .rust(|i, o| o.f(pow2(i.f())))
            .edges((-126..=127).map(|k| Row::from([k as f32]))),
        Twin::new("scale_by_pow2", file)
            .glsl("float y = in_f(); out_f(scale_by_pow2(y, in_f()));")
            .rust(|i, o| o.f(scale_by_pow2(i.f(), i.f())))
            .edges((-254..=254).map(|k| Row::from([-1.333_333_4, k as f32])))
            .seeded(1000, |r| {
                Row::new()
                    .f(r.range(-2.0, 2.0))
                    .f(r.below(300) as f32 - 160.0)
            }),
    ]
}

fn error_functions() -> Vec<Twin> {
    let (erfc_file, inverse) = ("math/elementary/erfc", "math/elementary/erfc_inverse");
    let ranged = |name, file, f: fn(f32) -> f32, low: f32, high: f32| {
        Twin::new(name, file)
            .glsl(&format!("out_f({name}(in_f()));"))
            .rust(move |i, o| o.f(f(i.f())))
            .edges([low, high].map(|x| Row::from([x])))
            .seeded(5000, move |r| Row::new().f(r.range(low, high)))
    };
    vec![
        unary("erfc", erfc_file, erfc)
            .edges([-0.5, 0.5, 9.19, 10.06, 11.0].map(|x| Row::from([x]))),
        Twin::new("erfc_gauss", erfc_file)
            .glsl("ErfcGauss g = erfc_gauss(in_f()); out_f(g.erfc); out_f(g.gauss);")
            .rust(|i, o| {
                let g = erfc_gauss(i.f());
                o.f(g.erfc);
                o.f(g.gauss);
            })
            .edges([-0.5, 0.5, 9.19, 10.06, 11.0].map(|x| Row::from([x])))
            .seeded(5000, |r| Row::new().f(r.range(-11.0, 11.0))),
        ranged("exp_minus_square", erfc_file, exp_minus_square, -11.0, 11.0),
        unary("erfc_inverse", inverse, erfc_inverse)
            .edges([0.5, 1.5, 2.0, 5.421_011e-20].map(|x| Row::from([x])))
            .seeded(20_000, |r| Row::new().f(r.range(0.0, 2.0)))
            .seeded(5000, |r| Row::new().f(r.log_range(1e-44, 1.0))),
        ranged("erfc_inverse_near", inverse, erfc_inverse_near, 0.0, 5.0),
        ranged("erfc_inverse_far", inverse, erfc_inverse_far, 2.236, 10.2),
    ]
}

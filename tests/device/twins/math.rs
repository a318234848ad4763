//! Twins of `shaders/math/`.

use vkpt::reference::math::finite::{is_black, is_finite, is_finite3};
use vkpt::reference::math::frame::{Frame, frame_about, to_local, to_world};
use vkpt::reference::math::products::{difference_of_products, halves, product_error};
use vkpt::reference::math::{
    Vec3, cross3, dot3, length3, max_component, max2, mean3, min2, normalize3, vec3,
};

use super::harness::{Out, Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    let mut twins = vectors();
    twins.extend(frames());
    twins.push(finiteness());
    twins.extend(products());
    twins
}

/// Zeros of both signs, denormals, neighbours of 1, ends of the range, infinities, a NaN.
pub const SPECIAL: [f32; 18] = [
    0.0,
    -0.0,
    1e-45,
    -1e-45,
    1.175_494_4e-38,
    -1e-38,
    1.0,
    -1.0,
    0.999_999_94,
    -0.999_999_94,
    1.000_000_1,
    -1.000_000_1,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    0.5,
];

/// Every pair of special numbers.
fn special_pairs() -> impl Iterator<Item = Row> {
    SPECIAL
        .into_iter()
        .flat_map(|a| SPECIAL.map(|b| Row::from([a, b])))
}

/// A vector of components of any size, some of them zero.
fn wild_vec3(r: &mut Rng) -> Vec3<f32> {
    let mut component = || {
        if r.below(8) == 0 {
            0.0
        } else {
            r.range(-1.0, 1.0) * r.log_range(1e-12, 1e12)
        }
    };
    vec3(component(), component(), component())
}

fn vector(name: &'static str, f: impl Fn(Vec3<f32>, &mut Out) + 'static, out: &str) -> Twin {
    Twin::new(name, "math/vec")
        .glsl(&format!("{out}({name}(in_vec3()));"))
        .rust(move |i, o| f(i.vec3(), o))
        .edges(SPECIAL.map(|x| Row::from([x, 1.0, -0.0])))
        .edges(SPECIAL.map(|x| Row::from([-0.0, x, x])))
        .seeded(2000, |r| Row::new().vec3(wild_vec3(r)))
}

fn vectors() -> Vec<Twin> {
    let pairs = |t: Twin| t.seeded(2000, |r| Row::new().vec3(wild_vec3(r)).vec3(wild_vec3(r)));
    let scalars = |t: Twin| {
        t.edges(special_pairs())
            .seeded(500, |r| Row::new().f(r.finite()).f(r.finite()))
    };
    vec![
        scalars(
            Twin::new("min2", "math/vec")
                .glsl("float a = in_f(); out_f(min2(a, in_f()));")
                .rust(|i, o| o.f(min2(i.f(), i.f()))),
        ),
        scalars(
            Twin::new("max2", "math/vec")
                .glsl("float a = in_f(); out_f(max2(a, in_f()));")
                .rust(|i, o| o.f(max2(i.f(), i.f()))),
        ),
        pairs(
            Twin::new("dot3", "math/vec")
                .glsl("vec3 a = in_vec3(); out_f(dot3(a, in_vec3()));")
                .rust(|i, o| o.f(dot3(i.vec3(), i.vec3()))),
        ),
        pairs(
            Twin::new("cross3", "math/vec")
                .glsl("vec3 a = in_vec3(); out_vec3(cross3(a, in_vec3()));")
                .rust(|i, o| o.vec3(cross3(i.vec3(), i.vec3()))),
        ),
        vector("length3", |v, o| o.f(length3(v)), "out_f"),
        vector("normalize3", |v, o| o.vec3(normalize3(v)), "out_vec3"),
        vector("max_component", |v, o| o.f(max_component(v)), "out_f"),
        vector("mean3", |v, o| o.f(mean3(v)), "out_f"),
    ]
}

fn out_frame(f: Frame<f32>, o: &mut Out) {
    o.vec3(f.t);
    o.vec3(f.b);
    o.vec3(f.n);
}

fn frames() -> Vec<Twin> {
    let axes = [
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, -0.0],
        [3.452_669_8e-4, 0.0, -0.999_999_94],
        [1e-20, -1e-40, -1.0],
    ];
    let about_and_vector = |t: Twin| {
        t.edges(axes.map(|[x, y, z]| Row::from([x, y, z, 0.6, -0.0, 0.8])))
            .seeded(2000, |r| Row::new().vec3(r.direction()).vec3(r.direction()))
    };
    vec![
        Twin::new("frame_about", "math/frame")
            .glsl("Frame f = frame_about(in_vec3()); out_vec3(f.t); out_vec3(f.b); out_vec3(f.n);")
            .rust(|i, o| out_frame(frame_about(i.vec3()), o))
            .edges(axes.map(Row::from))
            .seeded(2000, |r| Row::new().vec3(r.direction())),
        about_and_vector(Twin::new("to_local", "math/frame"))
            .glsl("Frame f = frame_about(in_vec3()); out_vec3(to_local(f, in_vec3()));")
            .rust(|i, o| o.vec3(to_local(frame_about(i.vec3()), i.vec3()))),
        about_and_vector(Twin::new("to_world", "math/frame"))
            .glsl("Frame f = frame_about(in_vec3()); out_vec3(to_world(f, in_vec3()));")
            .rust(|i, o| o.vec3(to_world(frame_about(i.vec3()), i.vec3()))),
    ]
}

fn finiteness() -> Twin {
    Twin::new("is_finite", "math/finite")
        .also(&["is_finite3", "is_black"])
        .glsl(
            "vec3 v = in_vec3(); out_b(is_finite(v.x)); out_b(is_finite3(v)); out_b(is_black(v));",
        )
        .rust(|i, o| {
            let v = i.vec3();
            o.b(is_finite(v.x));
            o.b(is_finite3(v));
            o.b(is_black(v));
        })
        .edges(SPECIAL.iter().flat_map(|&x| {
            [vec3(x, 0.0, 0.0), vec3(0.0, x, 1.0), vec3(-0.0, -1.0, x)].map(|v| Row::new().vec3(v))
        }))
        .seeded(1000, |r| Row::new().u(r.u32()).u(r.u32()).u(r.u32()))
}

fn products() -> Vec<Twin> {
    // Factors of nearly equal products too: where it matters.
    let four = |t: Twin| {
        t.edges(
            [
                [1.0, 3.0, 3.0, 1.0],
                [0.0, 5.0, -0.0, 1e-30],
                [1e12, 1e-12, -1.0, 1.0],
            ]
            .map(Row::from),
        )
        .seeded(2000, |r| {
            let (a, b) = (r.range(1.0, 2.0), r.range(-2.0, 2.0));
            let k = r.log_range(1e-3, 1e3);
            Row::from([a, b, a * k, b / k])
        })
        .seeded(500, |r| {
            Row::from([(); 4].map(|()| r.range(-1.0, 1.0) * r.log_range(1e-6, 1e6)))
        })
    };
    vec![
        Twin::new("halves", "math/products")
            .glsl("Halves h = halves(in_f()); out_f(h.hi); out_f(h.lo);")
            .rust(|i, o| {
                let h = halves(i.f());
                o.f(h.hi);
                o.f(h.lo);
            })
            .edges([0.0, -0.0, 1.0, 4097.0, 1.000_000_1, -3.0e30].map(|x| Row::from([x])))
            .seeded(500, |r| Row::from([r.range(-1.0, 1.0) * r.log_range(1e-12, 1e12)])),
        Twin::new("product_error", "math/products")
            .glsl("float a = in_f(); float b = in_f(); out_f(product_error(halves(a), halves(b), a * b));")
            .rust(|i, o| {
                let (a, b) = (i.f(), i.f());
                o.f(product_error(halves(a), halves(b), a * b));
            })
            .edges([[1.000_000_1, 0.999_999_94], [-0.0, 7.0], [3.0, 3.0]].map(Row::from))
            .seeded(2000, |r| Row::from([r.range(-2.0, 2.0), r.range(-2.0, 2.0)])),
        four(
            Twin::new("difference_of_products", "math/products")
                .glsl("float a = in_f(); float b = in_f(); float c = in_f(); out_f(difference_of_products(a, b, c, in_f()));")
                .rust(|i, o| o.f(difference_of_products(i.f(), i.f(), i.f(), i.f()))),
        ),
    ]
}

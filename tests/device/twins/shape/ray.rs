//! Rays, the order among hits, stretches between planes.

use vkpt::prepared::NONE;
use vkpt::reference::math::vec3;
use vkpt::reference::shape::slab::{Slab, enters, first_of, slab};
use vkpt::reference::shape::{closer, no_hit, start_on};

use super::super::harness::{Row, Twin};
use super::{OUT_HIT, READ_HIT, READ_RAY, out_hit, prelude, read_hit, read_ray, some_shape};
use crate::twins::math::SPECIAL;

pub fn twins() -> Vec<Twin> {
    let mut twins = order();
    twins.extend(stretches());
    twins
}

fn order() -> Vec<Twin> {
    let x = vec3(1.0, 0.0, 0.0);
    vec![
        Twin::new("no_hit", "shape/ray")
            .prelude(prelude())
            .glsl(&format!("Hit found = no_hit(in_f()); {OUT_HIT}"))
            .rust(|i, o| out_hit(no_hit(i.f()), o))
            .edges(SPECIAL.map(|x| Row::from([x]))),
        Twin::new("closer", "shape/ray")
            .prelude(prelude())
            .glsl(&format!(
                "float t = in_f(); uint shape = in_u(); uint prim = in_u(); {READ_HIT} out_b(closer(t, shape, prim, hit));"
            ))
            .rust(|i, o| {
                let (t, shape, prim) = (i.f(), i.u(), i.u());
                o.b(closer(t, shape, prim, read_hit(i)));
            })
            .edge(Row::new().f(1.0).u(0).u(0).hit(1.0, NONE, NONE, [0.0; 2]))
            .edge(Row::new().f(f32::NAN).u(0).u(0).hit(1.0, 1, 1, [0.0; 2]))
            .seeded(2000, |r| {
                let few = |r: &mut super::Rng| [0.0, -0.0, 1.0, 3e38][r.below(4) as usize];
                let row = Row::new().f(few(r)).u(r.below(3)).u(r.below(3));
                let t = few(r);
                row.hit(t, some_shape(r), some_shape(r), [0.0; 2])
            }),
        Twin::new("start_on", "shape/ray")
            .prelude(prelude())
            .glsl(&format!("{READ_RAY} out_u(start_on(ray, in_u()));"))
            .rust(|i, o| {
                let ray = read_ray(i);
                o.u(start_on(ray, i.u()));
            })
            .seeded(200, move |r| {
                let on = [some_shape(r), some_shape(r), r.below(3)];
                Row::new().ray(x, x, on, 0.0).u(r.below(3))
            }),
    ]
}

/// A stretch with ends before, at and behind the start, and ends that no ray reaches.
fn ends(r: &mut super::Rng) -> Row {
    let mut end = || [0.0, -0.0, 3e38, -3e38, r.range(-2.0, 2.0)][r.below(5) as usize];
    let near = end();
    Row::from([near, end()])
}

fn stretches() -> Vec<Twin> {
    vec![
        Twin::new("slab", "shape/slab")
            .prelude(prelude())
            .glsl(
                "float o = in_f(); float d = in_f(); float lo = in_f(); float hi = in_f();
                 Slab s = slab(o, d, lo, hi, in_u()); out_f(s.near); out_f(s.far);",
            )
            .rust(|i, o| {
                let (at, d, lo, hi) = (i.f(), i.f(), i.f(), i.f());
                let s = slab(at, d, lo, hi, i.u());
                o.f(s.near);
                o.f(s.far);
            })
            .seeded(4000, |r| {
                let d = [
                    0.0,
                    -0.0,
                    1e-30,
                    -1e-31,
                    1e-45,
                    1.0,
                    -1.0,
                    r.range(-1.0, 1.0),
                ];
                let o = [0.0, 1.0, -0.0, 2.0, r.range(-3.0, 3.0)];
                let row = Row::from([o[r.below(5) as usize], d[r.below(8) as usize]]);
                row.f(-(r.below(2) as f32)).f(r.unit() + 1.0).u(r.below(3))
            }),
        Twin::new("enters", "shape/slab")
            .prelude(prelude())
            .glsl("vec2 s = in_vec2(); out_b(enters(Slab(s.x, s.y), in_u()));")
            .rust(|i, o| {
                let [near, far] = i.vec2();
                o.b(enters(Slab { near, far }, i.u()));
            })
            .seeded(500, |r| ends(r).u(r.below(3))),
        Twin::new("first_of", "shape/slab")
            .prelude(prelude())
            .glsl("vec2 s = in_vec2(); out_f(first_of(Slab(s.x, s.y), in_u()));")
            .rust(|i, o| {
                let [near, far] = i.vec2();
                o.f(first_of(Slab { near, far }, i.u()));
            })
            .seeded(500, |r| ends(r).u(r.below(3))),
    ]
}

//! Twins of `shaders/light/surroundings.glsl`, of a picture of 5 × 4 texels.

use std::sync::Arc;

use vkpt::film::Film;
use vkpt::kernel::Slot;
use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::light::Surroundings;
use vkpt::reference::light::surroundings::{
    Map, Row as TexelRow, fraction_of, height_and_radius, surroundings_column,
    surroundings_direction, surroundings_light_sample, surroundings_outside, surroundings_radiance,
    surroundings_row, surroundings_texel, surroundings_texel_pdf,
};
use vkpt::reference::math::frame::{Frame, frame_about};

use super::harness::{In, Rng, Row, Twin};
use super::light::{OUT_SAMPLE, out_sample, u24, uniforms};

const WIDTH: u32 = 5;
const HEIGHT: u32 = 4;

/// Its arrays, in each thread's own memory.
const WORDS: &str = "uint ends[20];
float values[60];
uint surroundings_end(uint i) { return ends[i]; }
float surroundings_value(uint i) { return values[i]; }
";

const FILL: &str = "surroundings[0].x = in_vec3();
    surroundings[0].width = 5u;
    surroundings[0].y = in_vec3();
    surroundings[0].height = 4u;
    surroundings[0].z = in_vec3();
    uint n = 0u;
    while (n < 4u) {
        surroundings_rows[n].top = in_f();
        surroundings_rows[n].bottom = in_f();
        surroundings_rows[n].pdf = in_f();
        surroundings_rows[n].end = in_u();
        n += 1u;
    }
    n = 0u;
    while (n < 20u) { ends[n] = in_u(); n += 1u; }
    n = 0u;
    while (n < 60u) { values[n] = in_f(); n += 1u; }";

fn read(i: &mut In) -> Surroundings<f32> {
    let map = Map {
        x: i.vec3(),
        width: WIDTH,
        y: i.vec3(),
        height: HEIGHT,
        z: i.vec3(),
    };
    let mut row = || TexelRow {
        top: i.f(),
        bottom: i.f(),
        pdf: i.f(),
        end: i.u(),
    };
    let rows = vec![row(), row(), row(), row()];
    let ends = (0..WIDTH * HEIGHT).map(|_| i.u()).collect();
    let rgb = (0..WIDTH * HEIGHT).map(|_| [i.f(), i.f(), i.f()]).collect();
    Surroundings {
        map,
        rows,
        ends: Arc::new(ends),
        picture: Arc::new(Film {
            width: WIDTH,
            height: HEIGHT,
            rgb,
        }),
    }
}

/// Counts that rise to 2²⁴, some of no width.
fn ends<const N: usize>(r: &mut Rng) -> [u32; N] {
    let mut ends = [0; N].map(|_| u24(r) + 1);
    ends[r.below(N as u32) as usize] = ends[r.below(N as u32) as usize];
    ends.sort_unstable();
    ends[N - 1] = 1 << 24;
    ends
}

/// In any frame, with any values.
fn picture(r: &mut Rng) -> Row {
    let Frame { t, b, n } = frame_about(r.direction());
    let mut row = Row::new().vec3(t).vec3(b).vec3(n);
    // Rows 1 and 2 of 4 are in the middle.
    let cap = std::f32::consts::FRAC_PI_8.sin().powi(2);
    let cosine = std::f32::consts::FRAC_1_SQRT_2;
    let edges = [(0.0, cap), (cosine, 0.0), (0.0, -cosine), (cap, 0.0)];
    for (end, (top, bottom)) in ends::<4>(r).into_iter().zip(edges) {
        row = row.f(top).f(bottom).f(r.log_range(1e-9, 1e-6)).u(end);
    }
    for _ in 0..HEIGHT {
        row = ends::<5>(r).into_iter().fold(row, Row::u);
    }
    (0..3 * WIDTH * HEIGHT).fold(row, |row, _| row.f(r.log_range(1e-5, 1e5)))
}

fn twin(name: &'static str, body: &str) -> Twin {
    let structs = device::Surroundings::glsl() + &device::SurroundingsRow::glsl();
    let arrays = "Surroundings surroundings[1];\nSurroundingsRow surroundings_rows[4];\n";
    Twin::new(name, "light/surroundings")
        .prelude(structs + arrays)
        .slot("surroundings_words", Slot::Text(WORDS.into()))
        .glsl(&format!("{FILL} {body}"))
}

pub fn twins() -> Vec<Twin> {
    let mut twins = seen();
    twins.extend(drawn());
    twins
}

/// The radiance seen along a direction, and of a texel.
fn seen() -> Vec<Twin> {
    vec![
        twin("surroundings_texel", "out_u(surroundings_texel(in_vec3()));")
            .rust(|i, o| {
                let s = read(i);
                o.u(surroundings_texel(&s, i.vec3()));
            })
            .seeded(2000, |r| picture(r).vec3(r.direction())),
        twin("surroundings_radiance", "out_vec3(surroundings_radiance(in_u()));")
            .rust(|i, o| {
                let s = read(i);
                o.vec3(surroundings_radiance(&s, i.u()));
            })
            .seeded(100, |r| picture(r).u(r.below(20))),
        twin("surroundings_texel_pdf", "out_f(surroundings_texel_pdf(in_u()));")
            .rust(|i, o| {
                let s = read(i);
                o.f(surroundings_texel_pdf(&s, i.u()));
            })
            .seeded(400, |r| picture(r).u(r.below(20))),
        twin(
            "surroundings_outside",
            "vec3 scale = in_vec3(); Outside s = surroundings_outside(scale, in_vec3()); out_vec3(s.radiance); out_f(s.pdf);",
        )
        .rust(|i, o| {
            let (s, scale) = (read(i), i.vec3());
            let seen = surroundings_outside(&s, scale, i.vec3());
            o.vec3(seen.radiance);
            o.f(seen.pdf);
        })
        .seeded(500, |r| picture(r).vec3(r.vec3(0.0, 10.0)).vec3(r.direction())),
    ]
}

/// How a direction is drawn.
fn drawn() -> Vec<Twin> {
    vec![
        twin("surroundings_row", "out_u(surroundings_row(in_u()));")
            .rust(|i, o| {
                let s = read(i);
                o.u(surroundings_row(&s, i.u()));
            })
            .seeded(500, |r| picture(r).u(u24(r))),
        twin(
            "surroundings_column",
            "uint first = in_u(); out_u(surroundings_column(first, in_u()));",
        )
        .rust(|i, o| {
            let (s, first) = (read(i), i.u());
            o.u(surroundings_column(&s, first, i.u()));
        })
        .seeded(500, |r| picture(r).u(5 * r.below(4)).u(u24(r))),
        twin(
            "fraction_of",
            "uint u24 = in_u(); uint begin = in_u(); out_f(fraction_of(u24, begin, in_u()));",
        )
        .rust(|i, o| {
            let (_, u24, begin) = (read(i), i.u(), i.u());
            o.f(fraction_of(u24, begin, i.u()));
        })
        .seeded(500, |r| {
            let mut all = [u24(r), u24(r), u24(r)];
            all.sort_unstable();
            picture(r).u(all[1]).u(all[0]).u(all[2] + 1)
        }),
        twin(
            "height_and_radius",
            "uint y = in_u(); uint height = in_u(); out_vec2(height_and_radius(y, height, in_f()));",
        )
        .rust(|i, o| {
            let (_, row, height) = (read(i), i.u(), i.u());
            o.vec2(height_and_radius(row, height, i.f()));
        })
        .seeded(1000, |r| {
            let height = 1 + r.below(9);
            picture(r).u(r.below(height)).u(height).f(r.unit())
        }),
        twin(
            "surroundings_direction",
            "uint y = in_u(); uint x = in_u(); float a = in_f(); out_vec3(surroundings_direction(y, x, a, in_f()));",
        )
        .rust(|i, o| {
            let (s, row, column, a) = (read(i), i.u(), i.u(), i.f());
            o.vec3(surroundings_direction(&s, row, column, a, i.f()));
        })
        .seeded(1000, |r| picture(r).u(r.below(4)).u(r.below(5)).f(r.unit()).f(r.unit())),
        twin(
            "surroundings_light_sample",
            &format!("LightSample s = surroundings_light_sample(in_vec2()); {OUT_SAMPLE}"),
        )
        .rust(|i, o| {
            let s = read(i);
            out_sample(surroundings_light_sample(&s, i.vec2()), o);
        })
        .seeded(4000, |r| picture(r).vec2(uniforms(r))),
    ]
}

//! Distributions of micro-normals: D, G1 and sampling.

use vkpt::reference::bsdf::distribution::{beckmann, ggx, micro_normal, phong, rational_g1};
use vkpt::reference::math::{Vec3, vec3};

use super::inputs::{uniform2, wo};
use crate::twins::harness::{Rng, Row, Twin};

type D = fn(Vec3<f32>, f32) -> f32;
type Sample = fn(f32, [f32; 2]) -> Vec3<f32>;

pub fn twins() -> Vec<Twin> {
    vec![
        micro_normal(),
        rational_g1(),
        distribution(
            ["ggx_d", "ggx_g1", "ggx_sample"],
            "bsdf/distribution/ggx",
            (ggx::ggx_d, ggx::ggx_g1, ggx::ggx_sample),
            |r| r.log_range(1e-6, 1.0),
        ),
        distribution(
            ["beckmann_d", "beckmann_g1", "beckmann_sample"],
            "bsdf/distribution/beckmann",
            (
                beckmann::beckmann_d,
                beckmann::beckmann_g1,
                beckmann::beckmann_sample,
            ),
            |r| r.log_range(1e-6, 1.0),
        ),
        distribution(
            ["phong_d", "phong_g1", "phong_sample"],
            "bsdf/distribution/phong",
            (phong::phong_d, phong::phong_g1, phong::phong_sample),
            |r| {
                if r.below(8) == 0 {
                    0.0
                } else {
                    r.log_range(1e-2, 1e8)
                }
            },
        ),
    ]
}

fn micro_normal() -> Twin {
    Twin::new("micro_normal", "bsdf/distribution/micro_normal")
        .also(&["micro_normal_at_tan2"])
        .glsl(
            "float s = in_f(); float c = in_f(); float u = in_f();
            out_vec3(micro_normal(s, c, u));
            out_vec3(micro_normal_at_tan2(in_f(), u));",
        )
        .rust(|i, o| {
            let (s, c, u) = (i.f(), i.f(), i.f());
            o.vec3(micro_normal::micro_normal(s, c, u));
            o.vec3(micro_normal::micro_normal_at_tan2(i.f(), u));
        })
        .edge([0.0, 1.0, 0.0, 0.0])
        .edge([1.0, 0.0, 0.25, 1e30])
        .seeded(500, |r| {
            let row = Row::new().f(r.unit()).f(r.unit()).f(r.unit());
            row.f(r.log_range(1e-20, 1e8))
        })
}

fn rational_g1() -> Twin {
    Twin::new("rational_g1", "bsdf/distribution/rational_g1")
        .glsl("vec3 v = in_vec3(); out_f(rational_g1(v, in_f()));")
        .rust(|i, o| {
            let v = i.vec3();
            o.f(rational_g1::rational_g1(v, i.f()));
        })
        .edge([0.0, 0.0, 1.0, 0.5])
        .edge([1.0, 0.0, 0.0, 0.5])
        .seeded(500, |r| {
            Row::new().vec3(r.direction()).f(r.log_range(1e-6, 1.0))
        })
}

/// D, G1 and sampling of one distribution; `alpha` draws its parameter.
fn distribution(
    names: [&'static str; 3],
    file: &'static str,
    (d, g1, sample): (D, D, Sample),
    alpha: fn(&mut Rng) -> f32,
) -> Twin {
    let [d_name, g1_name, sample_name] = names;
    let edges = [
        vec3(0.0, 0.0, 1.0),
        vec3(1.0, 0.0, 0.0),
        vec3(0.6, 0.0, -0.8),
        vec3(1.0, 0.0, 1e-12),
    ];
    let row = move |r: &mut Rng, v: Vec3<f32>| {
        let alpha = alpha(r);
        // near N, where D of a smooth surface is not 0
        let m = sample(alpha, [r.unit(), r.unit()]);
        let m = if r.bool() { m } else { v };
        Row::new()
            .vec3(m)
            .f(alpha)
            .vec3(v)
            .f(r.log_range(1e-6, 1.0))
            .vec2(uniform2(r))
    };
    Twin::new(d_name, file)
        .also(&[g1_name, sample_name])
        .glsl(&format!(
            "vec3 m = in_vec3(); float alpha = in_f();
            out_f({d_name}(m, alpha));
            vec3 v = in_vec3(); float width = in_f();
            out_f({g1_name}(v, width));
            out_vec3({sample_name}(alpha, in_vec2()));"
        ))
        .rust(move |i, o| {
            let (m, alpha) = (i.vec3(), i.f());
            o.f(d(m, alpha));
            let (v, width) = (i.vec3(), i.f());
            o.f(g1(v, width));
            o.vec3(sample(alpha, i.vec2()));
        })
        .edges(edges.map(|v| Row::new().vec3(v).f(1.0).vec3(v).f(1.0).vec2([0.0, 0.0])))
        .seeded(1000, move |r| {
            let v = if r.bool() { wo(r) } else { r.direction() };
            row(r, v)
        })
}

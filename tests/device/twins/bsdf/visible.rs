//! Visible normals: the plane of incidence, slopes along it, and the three distributions.

use vkpt::reference::bsdf::interaction::Interaction;
use vkpt::reference::bsdf::normals::visible::{beckmann, ggx, incidence, phong, slope};
use vkpt::reference::math::{Vec3, vec3};
use vkpt::settings::{Distribution, Settings};

use super::inputs::{put, surface, take, uniform, uniform2, wo};
use super::kernel::twin;
use crate::twins::harness::{Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    vec![
        plane(),
        laws(),
        steps(),
        leans(),
        distribution(
            ["visible_ggx_sample", "visible_ggx_pdf"],
            "bsdf/normals/visible/ggx",
            Distribution::Ggx,
            (ggx::visible_ggx_sample, ggx::visible_ggx_pdf),
        ),
        distribution(
            ["visible_beckmann_sample", "visible_beckmann_pdf"],
            "bsdf/normals/visible/beckmann",
            Distribution::Beckmann,
            (
                beckmann::visible_beckmann_sample,
                beckmann::visible_beckmann_pdf,
            ),
        ),
        distribution(
            ["visible_phong_sample", "visible_phong_pdf"],
            "bsdf/normals/visible/phong",
            Distribution::Phong,
            (phong::visible_phong_sample, phong::visible_phong_pdf),
        ),
    ]
}

fn plane() -> Twin {
    Twin::new("incidence", "bsdf/normals/visible/incidence")
        .also(&["incidence_to_frame", "incidence_from_frame", "above_zero"])
        .glsl(
            "Incidence plane = incidence(in_vec3()); vec3 v = in_vec3();
            out_f(plane.sine); out_f(plane.cos_phi); out_f(plane.sin_phi);
            out_vec3(incidence_to_frame(plane, v)); out_vec3(incidence_from_frame(plane, v));
            out_f(above_zero(in_f()));",
        )
        .rust(|i, o| {
            let plane = incidence::incidence(i.vec3());
            let v = i.vec3();
            o.f(plane.sine);
            o.f(plane.cos_phi);
            o.f(plane.sin_phi);
            o.vec3(incidence::incidence_to_frame(plane, v));
            o.vec3(incidence::incidence_from_frame(plane, v));
            o.f(incidence::above_zero(i.f()));
        })
        .edges(
            [vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0)].map(|v| Row::new().vec3(v).vec3(v).f(0.0)),
        )
        .seeded(500, |r| {
            let row = Row::new().vec3(wo(r)).vec3(r.direction());
            row.f(uniform(r))
        })
}

/// The laws of Beckmann of a width, of Phong of an exponent.
fn laws() -> Twin {
    let out =
        |law| format!("out_f({law}.p); out_f({law}.r); out_f({law}.gamma); out_f({law}.limit);");
    let settings = Settings::default();
    twin("beckmann_view", "bsdf/normals/visible/beckmann", &settings)
        .also(&["phong_law", "phong_along", "phong_across", "slope_law"])
        .file("bsdf/normals/visible/phong")
        .file("bsdf/normals/visible/slope")
        .glsl(&format!(
            "vec3 wo = in_vec3(); Incidence plane = incidence(wo);
            BeckmannView view = beckmann_view(wo, plane.sine, in_f()); out_f(view.len);
            float alpha = in_f(); SlopeLaw law = phong_law(wo, plane.sine, alpha);
            out_f(phong_along(alpha)); out_f(phong_across(alpha)); {} {}",
            out("view.law"),
            out("law"),
        ))
        .rust(|i, o| {
            let wo = i.vec3();
            let sine = incidence::incidence(wo).sine;
            let view = beckmann::beckmann_view(wo, sine, i.f());
            o.f(view.length);
            let alpha = i.f();
            let law = phong::phong_law(wo, sine, alpha);
            o.f(phong::phong_along(alpha));
            o.f(phong::phong_across(alpha));
            for law in [view.law, law] {
                o.f(law.p);
                o.f(law.r);
                o.f(law.gamma);
                o.f(law.limit);
            }
        })
        .edges([vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0)].map(|v| Row::new().vec3(v).f(1.0).f(0.0)))
        .seeded(1000, |r| {
            let row = Row::new().vec3(wo(r)).f(r.log_range(1e-4, 1.0));
            row.f(exponent(r))
        })
}

fn exponent(r: &mut Rng) -> f32 {
    match r.below(8) {
        0 => 0.0,
        _ => r.log_range(1e-2, 2e8),
    }
}

/// The inversion, from laws of all kinds.
fn steps() -> Twin {
    Twin::new("slope_sample", "bsdf/normals/visible/slope")
        .also(&["slope_share", "slope_start", "slope_step"])
        .glsl(
            "float p = in_f(); float r = in_f(); float gamma = in_f();
            SlopeLaw law = slope_law(p, r, gamma, in_f());
            SlopeShare whole = slope_share(law, -law.limit);
            out_f(whole.share); out_f(whole.gauss); out_f(whole.tilt);
            float u = in_f(); float t = slope_start(law, whole, above_zero(u));
            out_f(t); out_f(slope_step(law, above_zero(u) * whole.share, t));
            out_f(slope_sample(law, u));",
        )
        .rust(|i, o| {
            let (p, r, gamma) = (i.f(), i.f(), i.f());
            let law = slope::slope_law(p, r, gamma, i.f());
            let whole = slope::slope_share(law, -law.limit);
            o.f(whole.share);
            o.f(whole.gauss);
            o.f(whole.tilt);
            let u = i.f();
            let v = incidence::above_zero(u);
            let t = slope::slope_start(law, whole, v);
            o.f(t);
            o.f(slope::slope_step(law, v * whole.share, t));
            o.f(slope::slope_sample(law, u));
        })
        .seeded(5000, |r| {
            let (wo, alpha) = (wo(r), r.log_range(1e-4, 1.0));
            let sine = incidence::incidence(wo).sine;
            let law = match r.bool() {
                true => beckmann::beckmann_view(wo, sine, alpha).law,
                false => phong::phong_law(wo, sine, exponent(r)),
            };
            let row = Row::from([law.p, law.r, law.gamma, law.limit]);
            row.f(uniform(r))
        })
}

fn leans() -> Twin {
    let settings = Settings::default();
    twin("phong_lean", "bsdf/normals/visible/phong", &settings)
        .also(&["phong_excess"])
        .glsl("float x = in_f(); out_vec2(phong_lean(x, in_f())); out_f(phong_excess(in_f()));")
        .rust(|i, o| {
            let x = i.f();
            o.vec2(phong::phong_lean(x, i.f()).into());
            o.f(phong::phong_excess(i.f()));
        })
        .edges([0.0, 1e-45, 1e30, f32::INFINITY].map(|t2| Row::from([0.0, 1.5, t2])))
        .seeded(1000, |r| {
            let row = Row::new().f(r.range(-4.5, 5.0)).f(1.5 + exponent(r));
            row.f(r.log_range(1e-38, 1e38))
        })
}

type Sample = fn(&Interaction<f32>, [f32; 2]) -> Vec3<f32>;
type Pdf = fn(&Interaction<f32>, Vec3<f32>) -> f32;

fn distribution(
    [sample_name, pdf_name]: [&'static str; 2],
    file: &'static str,
    distribution: Distribution,
    (sample, pdf): (Sample, Pdf),
) -> Twin {
    twin(sample_name, file, &Settings::default())
        .also(&[pdf_name])
        .glsl(&format!(
            "Interaction at = in_interaction(); vec3 m = {sample_name}(at, in_vec2());
            out_vec3(m); out_f({pdf_name}(at, m)); out_f({pdf_name}(at, in_vec3()));"
        ))
        .rust(move |i, o| {
            let at = take(i);
            let m = sample(&at, i.vec2());
            o.vec3(m);
            o.f(pdf(&at, m));
            o.f(pdf(&at, i.vec3()));
        })
        .seeded(4000, move |r| {
            let (outside, at) = loop {
                let found = surface(r, false);
                if found.1.material.distribution == distribution {
                    break found;
                }
            };
            put(Row::new(), outside, &at)
                .vec2(uniform2(r))
                .vec3(r.direction())
        })
}

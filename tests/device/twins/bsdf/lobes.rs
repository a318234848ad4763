//! The lobes and their functions.

use vkpt::reference::bsdf::diffuse::lambert::{cosine_lobe, lambert_lobe};
use vkpt::reference::bsdf::facet::facet;
use vkpt::reference::bsdf::normals::normals_sample;
use vkpt::reference::bsdf::reflection::{
    reflect_about, reflection_half_vector, reflection_jacobian, reflection_lobe,
};
use vkpt::reference::bsdf::refraction::{
    bend, refract_about, refract_about_normal, refracted_cosine,
};
use vkpt::reference::bsdf::sample::{BsdfValue, no_sample, no_value, sample_or_none, value_if};
use vkpt::reference::bsdf::transmission::{
    transmission_half_vector, transmission_jacobian, transmission_lobe, transmitted,
};
use vkpt::reference::math::{dot3, vec3};
use vkpt::settings::Settings;

use super::inputs::{OUT_SAMPLE, OUT_VALUE, out_sample, out_value, put, surface, take, uniform2};
use super::kernel::{columns, twin};
use crate::twins::harness::{Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    let mut all = vec![sample(), lambert(), reflection(), refraction()];
    all.extend(columns().map(lobes));
    all
}

fn sample() -> Twin {
    let glsl = format!(
        "BsdfValue given = BsdfValue(in_vec3(), in_f());
        vec3 wi = in_vec3(); bool valid = in_b();
        BsdfSample s = sample_or_none(valid, wi, given, LOBE_REFLECTION | LOBE_DELTA); {OUT_SAMPLE}
        s = no_sample(); {OUT_SAMPLE}
        BsdfValue v = value_if(valid, given); {OUT_VALUE}
        v = no_value(); {OUT_VALUE}"
    );
    let row = |r: &mut Rng, pdf: f32| {
        let row = Row::new().vec3(r.vec3(0.0, 9.0)).f(pdf);
        row.vec3(r.direction()).u(r.bool().into())
    };
    Twin::new("sample_or_none", "bsdf/sample")
        .also(&["no_sample", "no_value", "value_if"])
        .glsl(&glsl)
        .rust(|i, o| {
            let value = BsdfValue {
                value: i.vec3(),
                pdf: i.f(),
            };
            let (wi, valid) = (i.vec3(), i.b());
            // LOBE_REFLECTION | LOBE_DELTA, as a number: the constants are part of the twin
            out_sample(o, sample_or_none(valid, wi, value, 2 | 4));
            out_sample(o, no_sample());
            out_value(o, value_if(valid, value));
            out_value(o, no_value());
        })
        .edge([1.0, 2.0, 3.0, f32::NAN, 0.0, 0.0, 1.0, 1.0])
        .edge([1.0, 2.0, 3.0, -1.0, 0.0, 0.0, 1.0, 1.0])
        .edge([1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0, 1.0])
        .seeded(200, move |r| {
            let pdf = r.log_range(1e-20, 1e20);
            row(r, pdf)
        })
}

fn lambert() -> Twin {
    let glsl = format!(
        "Interaction at = in_interaction();
        BsdfValue v = lambert_lobe(at, in_vec3()); {OUT_VALUE}
        out_vec3(cosine_lobe(in_vec2()));"
    );
    twin("lambert_lobe", "bsdf/diffuse/lambert", &Settings::default())
        .also(&["cosine_lobe"])
        .glsl(&glsl)
        .rust(|i, o| {
            let at = take(i);
            out_value(o, lambert_lobe(&at, i.vec3()));
            o.vec3(cosine_lobe(i.vec2()));
        })
        .seeded(500, |r| {
            let (outside, at) = surface(r, true);
            put(Row::new(), outside, &at)
                .vec3(r.direction())
                .vec2(uniform2(r))
        })
}

fn reflection() -> Twin {
    twin("reflect_about", "bsdf/reflection", &Settings::default())
        .also(&["reflection_half_vector", "reflection_jacobian"])
        .glsl(
            "vec3 wo = in_vec3(); vec3 m = in_vec3(); float c = in_f();
            out_vec3(reflect_about(wo, m, c)); out_vec3(reflection_half_vector(wo, m));
            out_f(reflection_jacobian(c));",
        )
        .rust(|i, o| {
            let (wo, m, c) = (i.vec3(), i.vec3(), i.f());
            o.vec3(reflect_about(wo, m, c));
            o.vec3(reflection_half_vector(wo, m));
            o.f(reflection_jacobian(c));
        })
        .edge([1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0])
        .seeded(500, |r| {
            let (wo, m) = (r.hemisphere(), r.hemisphere());
            Row::new().vec3(wo).vec3(m).f(dot3(wo, m))
        })
}

fn refraction() -> Twin {
    twin("refract_about", "bsdf/refraction", &Settings::default())
        .also(&["bend", "refracted_cosine", "refract_about_normal"])
        .glsl(
            "Interaction at = in_interaction(); vec3 m = in_vec3();
            float c = dot3(at.wo, m);
            out_f(refracted_cosine(at, c)); out_f(bend(at, c)); out_vec3(refract_about(at, m, c));
            out_vec3(refract_about_normal(at));",
        )
        .rust(|i, o| {
            let (at, m) = (take(i), i.vec3());
            let c = dot3(at.wo, m);
            o.f(refracted_cosine(&at, c));
            o.f(bend(&at, c));
            o.vec3(refract_about(&at, m, c));
            o.vec3(refract_about_normal(&at));
        })
        .seeded(2000, |r| {
            let (outside, at) = surface(r, false);
            put(Row::new(), outside, &at).vec3(r.hemisphere())
        })
}

/// A facet, both lobes through it, and their half vectors.
fn lobes(settings: Settings) -> Twin {
    let glsl = format!(
        "Interaction at = in_interaction(); vec3 wi = in_vec3();
        vec3 half_vector = transmission_half_vector(at, wi); out_vec3(half_vector);
        vec3 m = normals_sample(at, in_vec2());
        Facet x = facet(at, wi, m);
        out_f(x.c); out_f(x.ci); out_vec3(x.f); out_f(x.p_reflect); out_f(x.pm); out_f(x.dg);
        BsdfValue v = reflection_lobe(at, wi, x); {OUT_VALUE}
        v = transmission_lobe(at, wi, x); {OUT_VALUE}
        out_vec3(transmitted(at, x)); out_f(transmission_jacobian(at, x.c));"
    );
    twin("facet", "bsdf/facet", &settings)
        .also(&[
            "reflection_lobe",
            "transmission_lobe",
            "transmission_half_vector",
            "transmission_jacobian",
            "transmitted",
        ])
        .file("bsdf/reflection")
        .file("bsdf/transmission")
        .glsl(&glsl)
        .rust(move |i, o| {
            let (at, wi) = (take(i), i.vec3());
            o.vec3(transmission_half_vector(&at, wi));
            let m = normals_sample(&settings, &at, i.vec2());
            let x = facet(&settings, &at, wi, m);
            o.vec2([x.c, x.ci]);
            o.vec3(x.f);
            o.vec3(vec3(x.p_reflect, x.pm, x.dg));
            out_value(o, reflection_lobe(&at, wi, x));
            out_value(o, transmission_lobe(&settings, &at, wi, x));
            o.vec3(transmitted(&at, x));
            o.f(transmission_jacobian(&at, x.c));
        })
        .seeded(3000, |r| {
            let (outside, at) = surface(r, false);
            put(Row::new(), outside, &at)
                .vec3(r.direction())
                .vec2(uniform2(r))
        })
}

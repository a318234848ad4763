//! Interaction, Fresnel, choice, micro-normals, scaling: the code that fills the slots.

use vkpt::kernel::Slot;
use vkpt::reference::bsdf::choice::{diffuse_probability, reflect_probability};
use vkpt::reference::bsdf::diffuse::mixed;
use vkpt::reference::bsdf::fresnel::{exact, schlick};
use vkpt::reference::bsdf::normals::{normals_pdf, normals_sample};
use vkpt::reference::bsdf::sample::BsdfValue;
use vkpt::reference::bsdf::snell::{reflected_share, snell_radicand, total_reflection};
use vkpt::reference::bsdf::{Interaction, carried_mean, transmission_scale};
use vkpt::settings::Settings;

use super::inputs::{OUT_VALUE, out_value, put, surface, take, uniform, uniform2};
use super::kernel::{columns, twin};
use crate::twins::harness::{Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    let mut all = vec![interaction(), snell(), fresnel()];
    for settings in columns() {
        all.extend([
            normals(settings),
            choice(settings),
            scaling(settings),
            mixed(settings),
        ]);
        all.push(absent(settings));
    }
    all
}

/// A surface and a cosine.
fn surface_and_cosine(r: &mut Rng) -> Row {
    let (outside, at) = surface(r, true);
    let c = if r.bool() {
        at.wo.z
    } else {
        r.range(-0.1, 1.0)
    };
    put(Row::new(), outside, &at).f(c)
}

fn interaction() -> Twin {
    twin("interaction", "bsdf/interaction", &Settings::default())
        .also(&["carried_mean"])
        .glsl(
            "Interaction at = in_interaction();
            out_f(at.eta); out_f(at.one_minus_eta2); out_f(at.d);
            out_vec3(at.wo); out_vec3(at.attenuation); out_vec3(at.material.f0);
            out_vec3(at.carried); at.carried = in_vec3(); out_f(carried_mean(at, in_vec3()));",
        )
        .rust(|i, o| {
            let at = take(i);
            o.f(at.eta);
            o.f(at.one_minus_eta2);
            o.f(at.d);
            o.vec3(at.wo);
            o.vec3(at.attenuation);
            o.vec3(at.material.f0);
            o.vec3(at.carried);
            let carried = i.vec3();
            o.f(carried_mean(&Interaction { carried, ..at }, i.vec3()));
        })
        .seeded(100, |r| {
            let (outside, at) = surface(r, true);
            let row = put(Row::new(), outside, &at).vec3(r.vec3(0.0, 1.5));
            row.vec3(r.vec3(0.0, 1.0))
        })
}

fn snell() -> Twin {
    twin("snell_radicand", "bsdf/snell", &Settings::default())
        .also(&["total_reflection", "reflected_share"])
        .glsl(
            "Interaction at = in_interaction(); float c = in_f();
            out_f(snell_radicand(at, c)); out_b(total_reflection(at, c));
            out_vec3(reflected_share(at, c, at.material.f0));",
        )
        .rust(|i, o| {
            let (at, c) = (take(i), i.f());
            o.f(snell_radicand(&at, c));
            o.b(total_reflection(&at, c));
            o.vec3(reflected_share(&at, c, at.material.f0));
        })
        .seeded(1000, surface_and_cosine)
}

fn fresnel() -> Twin {
    twin("fresnel_exact", "bsdf/fresnel/exact", &Settings::default())
        .also(&["fresnel_schlick"])
        .file("bsdf/fresnel/schlick")
        .glsl(
            "Interaction at = in_interaction(); float c = in_f();
            out_vec3(fresnel_exact(at, c)); out_vec3(fresnel_schlick(at, c));",
        )
        .rust(|i, o| {
            let (at, c) = (take(i), i.f());
            o.vec3(exact::fresnel_exact(&at, c));
            o.vec3(schlick::fresnel_schlick(&at, c));
        })
        .seeded(2000, surface_and_cosine)
}

fn normals(settings: Settings) -> Twin {
    twin("normals_sample", "<normals>", &settings)
        .also(&["normals_pdf"])
        .glsl(
            "Interaction at = in_interaction();
            vec3 m = normals_sample(at, in_vec2());
            out_vec3(m); out_f(normals_pdf(at, m)); out_f(normals_pdf(at, in_vec3()));",
        )
        .rust(move |i, o| {
            let at = take(i);
            let m = normals_sample(&settings, &at, i.vec2());
            o.vec3(m);
            o.f(normals_pdf(&settings, &at, m));
            o.f(normals_pdf(&settings, &at, i.vec3()));
        })
        .seeded(2000, |r| {
            let (outside, at) = surface(r, false);
            put(Row::new(), outside, &at)
                .vec2(uniform2(r))
                .vec3(r.direction())
        })
}

fn choice(settings: Settings) -> Twin {
    twin("diffuse_probability", "<choice>", &settings)
        .also(&["reflect_probability"])
        .glsl(
            "Interaction at = in_interaction(); float c = in_f();
            out_f(diffuse_probability(at)); out_f(reflect_probability(at, c, 0.25));",
        )
        .rust(move |i, o| {
            let (at, c) = (take(i), i.f());
            o.f(diffuse_probability(&settings, &at));
            o.f(reflect_probability(&settings, &at, c, 0.25));
        })
        .seeded(1000, surface_and_cosine)
}

fn scaling(settings: Settings) -> Twin {
    twin("transmission_scale", "<scaling>", &settings)
        .glsl("out_f(transmission_scale(in_f()));")
        .rust(move |i, o| {
            let eta = i.f();
            o.f(transmission_scale(&settings, eta));
        })
        .edge([1.0])
        .seeded(100, |r| Row::new().f(r.log_range(0.1, 10.0)))
}

const MIXED: &str = "Interaction at = in_interaction(); vec3 wi = in_vec3(); vec2 u = in_vec2();
    out_b(diffuse_chosen(at, u.x)); out_f(facet_probability(at));
    BsdfValue v = with_diffuse(at, wi, BsdfValue(vec3(u, 0.5), u.x));";

fn beside(name: &'static str, settings: Settings, kd: bool) -> Twin {
    twin(name, "<diffuse>", &settings)
        .also(&["diffuse_chosen", "diffuse_direction", "facet_probability"])
        .rust(move |i, o| {
            let (at, wi, u) = (take(i), i.vec3(), i.vec2());
            o.b(mixed::diffuse_chosen(&settings, &at, u[0]));
            o.f(mixed::facet_probability(&settings, &at));
            let value = vkpt::reference::math::vec3(u[0], u[1], 0.5);
            let rest = BsdfValue { value, pdf: u[0] };
            out_value(o, mixed::with_diffuse(&settings, &at, wi, rest));
            if kd {
                o.vec3(mixed::diffuse_direction(u));
            }
        })
        .seeded(500, move |r| {
            let (outside, at) = surface(r, kd);
            let row = put(Row::new(), outside, &at).vec3(r.direction());
            row.f(uniform(r)).f(r.unit())
        })
}

fn mixed(settings: Settings) -> Twin {
    beside("with_diffuse", settings, true).glsl(&format!(
        "{MIXED}{OUT_VALUE} out_vec3(diffuse_direction(u));"
    ))
}

/// Without Kd, `absent` is `mixed`.
fn absent(settings: Settings) -> Twin {
    beside("with_diffuse", settings, false)
        .slot("diffuse", Slot::File("bsdf/diffuse/absent".into()))
        .glsl(&format!("{MIXED}{OUT_VALUE}"))
}

//! Kinds of material: sampling, and evaluation where light connections and samples look.

use vkpt::kernel::Slot;
use vkpt::prepared::MaterialKind;
use vkpt::reference::bsdf::kind::{rough_dielectric, smooth_dielectric, weak_dielectric};
use vkpt::reference::bsdf::normals::normals_sample;
use vkpt::reference::bsdf::rough::{
    rough_draw, rough_reflection_at, rough_reflection_sample, rough_reflects,
};
use vkpt::reference::bsdf::{BsdfRandom, bsdf_eval, bsdf_sample};
use vkpt::settings::Settings;

use super::inputs::{
    OUT_SAMPLE, OUT_VALUE, out_sample, out_value, put, surface_of, take, uniform, uniform2,
};
use super::kernel::{columns, twin};
use crate::twins::harness::{Rng, Row, Twin};

/// Name of sampling, of evaluation, file, kind.
const KINDS: [(&str, &str, &str, MaterialKind); 6] = [
    (
        "diffuse_sample",
        "diffuse_eval",
        "bsdf/kind/diffuse",
        MaterialKind::Diffuse,
    ),
    (
        "glossy_sample",
        "glossy_eval",
        "bsdf/kind/glossy",
        MaterialKind::Glossy,
    ),
    (
        "mirror_sample",
        "mirror_eval",
        "bsdf/kind/mirror",
        MaterialKind::Mirror,
    ),
    (
        "rough_dielectric_sample",
        "rough_dielectric_eval",
        "bsdf/kind/rough_dielectric",
        MaterialKind::RoughDielectric,
    ),
    (
        "smooth_dielectric_sample",
        "smooth_dielectric_eval",
        "bsdf/kind/smooth_dielectric",
        MaterialKind::SmoothDielectric,
    ),
    (
        "weak_dielectric_sample",
        "weak_dielectric_eval",
        "bsdf/kind/weak_dielectric",
        MaterialKind::WeakDielectric,
    ),
];

pub fn twins() -> Vec<Twin> {
    let mut all = Vec::new();
    for settings in columns() {
        for (sample, eval, file, kind) in KINDS {
            all.push(scatters(settings, sample, eval, file, kind, true));
            if kind != MaterialKind::Diffuse {
                let absent = Slot::File("bsdf/diffuse/absent".into());
                let twin = scatters(settings, sample, eval, file, kind, false);
                all.push(twin.slot("diffuse", absent));
            }
        }
        all.push(parts(settings));
    }
    all
}

/// A surface of the kind, the random numbers of a sample, and a `wi`: any, or the one that they draw.
fn scattering(r: &mut Rng, settings: &Settings, kd: bool, kind: MaterialKind) -> Row {
    let (outside, at) = surface_of(r, kd, &[kind]);
    let random = BsdfRandom {
        lobe: uniform(r),
        reflect: uniform(r),
        m: uniform2(r),
        d: uniform2(r),
    };
    let drawn = bsdf_sample(settings, &at, random).wi;
    let wi = if r.bool() { drawn } else { r.direction() };
    let row = put(Row::new(), outside, &at);
    let row = row.f(random.lobe).f(random.reflect);
    row.vec2(random.m).vec2(random.d).vec3(wi)
}

fn scatters(
    settings: Settings,
    sample: &'static str,
    eval: &'static str,
    file: &'static str,
    kind: MaterialKind,
    kd: bool,
) -> Twin {
    let glsl = format!(
        "Interaction at = in_interaction();
        BsdfRandom random; random.lobe = in_f(); random.reflect = in_f(); random.m = in_vec2(); random.d = in_vec2();
        BsdfSample s = {sample}(at, random); {OUT_SAMPLE}
        BsdfValue v = {eval}(at, in_vec3()); {OUT_VALUE}"
    );
    twin(sample, file, &settings)
        .also(&[eval])
        .glsl(&glsl)
        .rust(move |i, o| {
            let at = take(i);
            let random = BsdfRandom {
                lobe: i.f(),
                reflect: i.f(),
                m: i.vec2(),
                d: i.vec2(),
            };
            out_sample(o, bsdf_sample(&settings, &at, random));
            out_value(o, bsdf_eval(&settings, &at, i.vec3()));
        })
        .seeded(2000, move |r| scattering(r, &settings, kd, kind))
}

/// The functions that kinds use, each on surfaces of all kinds that transmit.
fn parts(settings: Settings) -> Twin {
    let glsl = format!(
        "Interaction at = in_interaction(); vec3 wi = in_vec3(); vec2 u = in_vec2();
        vec3 m = normals_sample(at, u);
        BsdfValue v = rough_reflection_at(at, wi, m); {OUT_VALUE}
        v = rough_dielectric_at(at, wi, m); {OUT_VALUE}
        BsdfSample s = weak_dielectric_transmission(at, wi, m); {OUT_SAMPLE}
        BsdfRandom random = BsdfRandom(u.y, u.x, u, u);
        s = smooth_dielectric_delta(at, random); {OUT_SAMPLE}
        RoughDraw draw = rough_draw(at, random);
        out_b(draw.diffuse); out_vec3(draw.m); out_f(draw.c); out_b(rough_reflects(at, draw, random));
        s = rough_reflection_sample(at, draw, random); {OUT_SAMPLE}"
    );
    twin(
        "rough_dielectric_at",
        "bsdf/kind/rough_dielectric",
        &settings,
    )
    .also(&["weak_dielectric_transmission", "smooth_dielectric_delta"])
    .also(&[
        "rough_reflection_at",
        "rough_draw",
        "rough_reflects",
        "rough_reflection_sample",
    ])
    .file("bsdf/kind/weak_dielectric")
    .file("bsdf/kind/smooth_dielectric")
    .glsl(&glsl)
    .rust(move |i, o| {
        let (at, wi, u) = (take(i), i.vec3(), i.vec2());
        let m = normals_sample(&settings, &at, u);
        out_value(o, rough_reflection_at(&settings, &at, wi, m));
        out_value(
            o,
            rough_dielectric::rough_dielectric_at(&settings, &at, wi, m),
        );
        out_sample(
            o,
            weak_dielectric::weak_dielectric_transmission(&settings, &at, wi, m),
        );
        let random = BsdfRandom {
            lobe: u[1],
            reflect: u[0],
            m: u,
            d: u,
        };
        out_sample(
            o,
            smooth_dielectric::smooth_dielectric_delta(&settings, &at, random),
        );
        let draw = rough_draw(&settings, &at, random);
        o.b(draw.diffuse);
        o.vec3(draw.m);
        o.f(draw.c);
        o.b(rough_reflects(&settings, &at, draw, random));
        out_sample(o, rough_reflection_sample(&settings, &at, draw, random));
    })
    .seeded(1000, |r| {
        let kinds = [
            MaterialKind::RoughDielectric,
            MaterialKind::SmoothDielectric,
            MaterialKind::WeakDielectric,
        ];
        let (outside, at) = surface_of(r, true, &kinds);
        put(Row::new(), outside, &at)
            .vec3(r.direction())
            .vec2(uniform2(r))
    })
}

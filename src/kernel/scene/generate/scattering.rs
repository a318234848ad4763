//! The scattering of materials.

use super::uses;
use crate::features::Features;
use crate::kernel::scene::dispatch::Dispatch;
use crate::prepared::MaterialKind;
use crate::settings::{Distribution, Fresnel};

/// File of `bsdf/kind/` and stem of its functions; `None` for a kind that never scatters.
fn kind_file(kind: MaterialKind) -> Option<&'static str> {
    Some(match kind {
        MaterialKind::Black | MaterialKind::NullInterface => return None,
        MaterialKind::Diffuse => "diffuse",
        MaterialKind::Glossy => "glossy",
        MaterialKind::Mirror => "mirror",
        MaterialKind::RoughDielectric => "rough_dielectric",
        MaterialKind::SmoothDielectric => "smooth_dielectric",
        MaterialKind::WeakDielectric => "weak_dielectric",
    })
}

pub fn bsdf(features: &Features) -> String {
    let kinds: Vec<_> = features
        .materials
        .iter()
        .filter_map(|&k| Some((k as u32, kind_file(k)?)))
        .collect();
    let members = |suffix: &str| -> Vec<(u32, String)> {
        kinds
            .iter()
            .map(|(k, stem)| (*k, format!("{stem}_{suffix}")))
            .collect()
    };
    let sample = Dispatch {
        result: "BsdfSample",
        name: "bsdf_sample",
        arguments: &[("Interaction", "at"), ("BsdfRandom", "random")],
        selector: "at.material.kind",
    };
    let eval = Dispatch {
        result: "BsdfValue",
        name: "bsdf_eval",
        arguments: &[("Interaction", "at"), ("vec3", "wi")],
        selector: "at.material.kind",
    };
    uses(
        "bsdf/sample",
        kinds.iter().map(|k| format!("bsdf/kind/{}", k.1)),
    ) + &sample.text(&members("sample(at, random)"), "no_sample()")
        + &eval.text(&members("eval(at, wi)"), "no_value()")
}

/// File of `bsdf/distribution/` and of `bsdf/normals/visible/`, and stem of their functions.
fn stem(distribution: Distribution) -> &'static str {
    match distribution {
        Distribution::Phong => "phong",
        Distribution::Beckmann => "beckmann",
        Distribution::Ggx => "ggx",
    }
}

/// The distributions of a scene, and a call for each.
fn calls(features: &Features, call: impl Fn(Distribution) -> String) -> Vec<(u32, String)> {
    let each = features.distributions.iter();
    each.map(|&d| (d as u32, call(d))).collect()
}

pub fn distribution(features: &Features) -> String {
    let function = |result, name, arguments| Dispatch {
        result,
        name,
        arguments,
        selector: "material.distribution",
    };
    let file = |&d| format!("bsdf/distribution/{}", stem(d));
    uses("math/vec", features.distributions.iter().map(file))
        + &function(
            "float",
            "distribution_d",
            &[("Material", "material"), ("vec3", "m")],
        )
        .text(
            &calls(features, |d| format!("{}_d(m, material.alpha)", stem(d))),
            "0.0",
        )
        + &function(
            "float",
            "distribution_g1",
            &[("Material", "material"), ("vec3", "v")],
        )
        .text(
            &calls(features, |d| format!("{}_g1(v, material.width)", stem(d))),
            "1.0",
        )
        + &function(
            "vec3",
            "distribution_sample",
            &[("Material", "material"), ("vec2", "u")],
        )
        .text(
            &calls(features, |d| {
                format!("{}_sample(material.alpha, u)", stem(d))
            }),
            "vec3(0.0, 0.0, 1.0)",
        )
}

pub fn visible(features: &Features) -> String {
    let selector = "at.material.distribution";
    let sample = Dispatch {
        result: "vec3",
        name: "visible_sample",
        arguments: &[("Interaction", "at"), ("vec2", "u")],
        selector,
    };
    let pdf = Dispatch {
        result: "float",
        name: "visible_pdf",
        arguments: &[("Interaction", "at"), ("vec3", "m")],
        selector,
    };
    let samples = calls(features, |d| format!("visible_{}_sample(at, u)", stem(d)));
    let pdfs = calls(features, |d| format!("visible_{}_pdf(at, m)", stem(d)));
    let file = |&d| format!("bsdf/normals/visible/{}", stem(d));
    uses("bsdf/interaction", features.distributions.iter().map(file))
        + &sample.text(&samples, "vec3(0.0, 0.0, 1.0)")
        + &pdf.text(&pdfs, "0.0")
}

pub fn fresnel(features: &Features) -> String {
    let stem = |f: Fresnel| match f {
        Fresnel::Schlick => "schlick",
        Fresnel::Exact => "exact",
    };
    let dispatch = Dispatch {
        result: "vec3",
        name: "fresnel",
        arguments: &[("Interaction", "at"), ("float", "c")],
        selector: "at.material.fresnel",
    };
    let members: Vec<_> = features
        .fresnel
        .iter()
        .map(|&f| (f as u32, format!("fresnel_{}(at, c)", stem(f))))
        .collect();
    let file = |&f| format!("bsdf/fresnel/{}", stem(f));
    uses("bsdf/interaction", features.fresnel.iter().map(file))
        + &dispatch.text(&members, "vec3(0.0)")
}

//! The kernels of the rows: slots filled for the settings, and the code that reads an interaction.

use vkpt::kernel::Slot;
use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::settings::{LobeChoice, Normals, Settings};

use crate::twins::harness::Twin;

/// Reads the data that `inputs::put` has written.
const READ: &str = "// uses: bsdf/interaction
Interaction in_interaction() {
    Material m;
    m.kd = in_vec3();
    m.kd_mean = in_f();
    m.f0 = in_vec3();
    m.alpha = in_f();
    m.width = in_f();
    m.eta = in_vec2();
    m.one_minus_eta2 = in_vec2();
    m.d = in_vec2();
    m.p_d = in_f();
    m.p_r = in_f();
    m.kind = in_u();
    m.distribution = in_u();
    m.fresnel = in_u();
    bool outside = in_b();
    vec3 wo = in_vec3();
    return interaction(m, outside, wo, in_vec3());
}
";

/// All distributions at once, as the composer writes the dispatch.
const DISTRIBUTION: &str =
    "// uses: bsdf/distribution/phong, bsdf/distribution/beckmann, bsdf/distribution/ggx
float distribution_d(Material material, vec3 m) {
    float result;
    switch (material.distribution) {
        case 0u: { result = phong_d(m, material.alpha); break; }
        case 1u: { result = beckmann_d(m, material.alpha); break; }
        default: { result = ggx_d(m, material.alpha); break; }
    }
    return result;
}
float distribution_g1(Material material, vec3 v) {
    float result;
    switch (material.distribution) {
        case 0u: { result = phong_g1(v, material.width); break; }
        case 1u: { result = beckmann_g1(v, material.width); break; }
        default: { result = ggx_g1(v, material.width); break; }
    }
    return result;
}
vec3 distribution_sample(Material material, vec2 u) {
    vec3 result;
    switch (material.distribution) {
        case 0u: { result = phong_sample(material.alpha, u); break; }
        case 1u: { result = beckmann_sample(material.alpha, u); break; }
        default: { result = ggx_sample(material.alpha, u); break; }
    }
    return result;
}
";

const VISIBLE: &str =
    "// uses: bsdf/normals/visible/phong, bsdf/normals/visible/beckmann, bsdf/normals/visible/ggx
vec3 visible_sample(Interaction at, vec2 u) {
    vec3 result;
    switch (at.material.distribution) {
        case 0u: { result = visible_phong_sample(at, u); break; }
        case 1u: { result = visible_beckmann_sample(at, u); break; }
        default: { result = visible_ggx_sample(at, u); break; }
    }
    return result;
}
float visible_pdf(Interaction at, vec3 m) {
    float result;
    switch (at.material.distribution) {
        case 0u: { result = visible_phong_pdf(at, m); break; }
        case 1u: { result = visible_beckmann_pdf(at, m); break; }
        default: { result = visible_ggx_pdf(at, m); break; }
    }
    return result;
}
";

const FRESNEL: &str = "// uses: bsdf/fresnel/schlick, bsdf/fresnel/exact
vec3 fresnel(Interaction at, float c) {
    vec3 result;
    switch (at.material.fresnel) {
        case 0u: { result = fresnel_schlick(at, c); break; }
        default: { result = fresnel_exact(at, c); break; }
    }
    return result;
}
";

/// The two columns of settings (model.md, "Settings").
pub fn columns() -> [Settings; 2] {
    [Settings::default(), Settings::handout()]
}

/// A twin whose kernel has the materials, the slots that `settings` ask for, and `in_interaction()`.
pub fn twin(name: &'static str, file: &'static str, settings: &Settings) -> Twin {
    let file_slot = |path: &str| Slot::File(path.into());
    let normals = match settings.estimator.normals {
        Normals::Visible => "bsdf/normals/visible",
        Normals::Distribution => "bsdf/normals/distribution",
    };
    let choice = match settings.estimator.lobe {
        LobeChoice::Fresnel => "bsdf/choice/fresnel",
        LobeChoice::Norms => "bsdf/choice/norms",
    };
    let scaling = if settings.model.radiance_scaling {
        "bsdf/scaling/radiance"
    } else {
        "bsdf/scaling/flux"
    };
    Twin::new(name, file)
        .prelude(device::Material::glsl())
        .slot("distribution", Slot::Text(DISTRIBUTION.into()))
        .slot("visible", Slot::Text(VISIBLE.into()))
        .slot("fresnel", Slot::Text(FRESNEL.into()))
        .slot("normals", file_slot(normals))
        .slot("choice", file_slot(choice))
        .slot("scaling", file_slot(scaling))
        .slot("diffuse", file_slot("bsdf/diffuse/mixed"))
        .source("twin/interaction", READ)
        .file("twin/interaction")
}

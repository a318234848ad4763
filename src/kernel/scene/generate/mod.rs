//! Generated text: which of several functions a shape, a material or a light calls.

mod geometry;
mod light;
mod scattering;
mod surroundings;
mod written_out;

use super::Parameters;
use crate::features::Features;
use crate::flat::bvh::leaf_text;

/// Slots filled with generated text.
pub fn texts(features: &Features, parameters: &Parameters) -> Vec<(&'static str, String)> {
    let mut texts = vec![
        ("surface", geometry::surface(features)),
        ("bsdf", scattering::bsdf(features)),
        ("distribution", scattering::distribution(features)),
        ("visible", scattering::visible(features)),
        ("fresnel", scattering::fresnel(features)),
        ("light", light::light(features)),
        ("outside", light::outside(parameters)),
        ("surroundings_words", surroundings::words(parameters)),
        ("light_emission", light::emission(features)),
        ("emission_pdf", light::emission_pdf(features)),
        ("triangles", geometry::triangles(features)),
        ("nearest", geometry::nearest(features, parameters)),
        ("covered", geometry::covered(features)),
        ("face_point", geometry::face_point(features)),
    ];
    if !features.in_bvh.is_empty() {
        texts.push(("leaf", leaf_text(features.in_bvh.iter().copied())));
    }
    texts
}

/// A `// uses:` line for these files.
fn uses(fixed: &str, files: impl Iterator<Item = impl AsRef<str>>) -> String {
    let more: String = files.map(|f| format!(", {}", f.as_ref())).collect();
    format!("// uses: {fixed}{more}\n")
}

//! Explicit sampling of emitters.

use super::uses;
use crate::features::Features;
use crate::kernel::scene::Parameters;
use crate::kernel::scene::dispatch::Dispatch;
use crate::shape::{Description, LightKind, filled};

const LIGHT: &str = "lights[light]";

/// A dispatch by the kind of `light`.
fn function<'a>(
    result: &'a str,
    name: &'a str,
    arguments: &'a [(&'a str, &'a str)],
) -> Dispatch<'a> {
    Dispatch {
        result,
        name,
        arguments,
        selector: "lights[light].kind",
    }
}

/// The call for each kind of light: that of its shape, or one of `outside`, for the constant
/// background and for surroundings.
fn calls(
    features: &Features,
    of_shape: impl Fn(&Description) -> &str,
    outside: [&str; 2],
) -> Vec<(u32, String)> {
    let call = |kind: LightKind| {
        let Some(shape) = kind.shape() else {
            let [background, surroundings] = outside;
            let own = match kind == LightKind::Surroundings {
                true => surroundings,
                false => background,
            };
            return own.to_owned();
        };
        let shape = shape.description();
        let x = filled(shape.element, &[("{i}", &format!("{LIGHT}.first"))]);
        filled(of_shape(shape), &[("{x}", &x), ("{light}", LIGHT)])
    };
    (features.lights.iter())
        .map(|&kind| (kind as u32, call(kind)))
        .collect()
}

/// Where light paths begin: `light_emission`.
pub fn emission(features: &Features) -> String {
    let arguments = [("uint", "light"), ("uint", "u24"), ("vec2", "u")];
    let members = calls(features, |shape| shape.emission, ["no_emission()"; 2]);
    let shapes = features.lights.iter().filter_map(|kind| kind.shape());
    let files = shapes.map(|shape| shape.description().emission_file);
    uses("light/emission/point", files)
        + &function("Emission", "light_emission", &arguments).text(&members, "no_emission()")
}

/// The density with which they begin at a point: `emission_pdf`.
pub fn emission_pdf(features: &Features) -> String {
    let arguments = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "prim"),
        ("vec3", "wi"),
    ];
    let members = calls(features, |shape| shape.emission_pdf, ["0.0"; 2]);
    let shapes = features.lights.iter().filter_map(|kind| kind.shape());
    let files = shapes.map(|shape| shape.description().emission_file);
    uses("light/emission/point", files)
        + &function("float", "emission_pdf", &arguments).text(&members, "0.0")
}

/// Explicit sampling: `light_sample`, `light_radiance` of the sample, and `light_pdf` for a hit.
pub fn light(features: &Features) -> String {
    let sample = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "u24"),
        ("vec2", "u"),
    ];
    let pdf = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "prim"),
        ("float", "cosine"),
        ("float", "distance"),
    ];
    let samples = calls(features, |s| s.light_sample, OUTSIDE_SAMPLES);
    let pdfs = calls(features, |s| s.light_pdf, ["0.0"; 2]);
    let none = "LightSample(vec3(0.0), -1.0, 0.0, 1.0, NONE)";
    uses("light/sample", features.lights.iter().map(file))
        + &function("LightSample", "light_sample", &sample).text(&samples, none)
        + &function("float", "light_pdf", &pdf).text(&pdfs, "0.0")
        + &radiance(features)
}

const OUTSIDE_SAMPLES: [&str; 2] = ["background_light_sample(u)", "surroundings_light_sample(u)"];

/// The file with the sampling of a kind.
fn file(kind: &LightKind) -> &'static str {
    match (kind.shape(), kind) {
        (Some(shape), _) => shape.description().light_file,
        (None, LightKind::Surroundings) => "light/surroundings",
        (None, _) => "light/background",
    }
}

/// Radiance of a light at a point of primitive `prim`, or of the texel `prim` of surroundings: `light_radiance`.
fn radiance(features: &Features) -> String {
    let own = format!("{LIGHT}.radiance");
    let of_texel = format!("{own} * surroundings_radiance(prim)");
    let has = |kind| features.lights.contains(&kind);
    let mut members = Vec::new();
    if has(LightKind::Surroundings) {
        members.push((LightKind::Surroundings as u32, of_texel));
    }
    if members.is_empty() || features.lights.len() > 1 {
        members.push((u32::MAX, own));
    }
    function(
        "vec3",
        "light_radiance",
        &[("uint", "light"), ("uint", "prim")],
    )
    .text(&members, "")
}

/// The light that a path sees when it leaves the scene: `outside_seen`.
pub fn outside(parameters: &Parameters) -> String {
    let radiance = "lights[BACKGROUND_LIGHT].radiance";
    let value = match parameters.outside {
        None => "Outside(vec3(0.0), 0.0)".to_owned(),
        Some(LightKind::Surroundings) => format!("surroundings_outside({radiance}, wi)"),
        Some(_) => format!("background_outside({radiance})"),
    };
    let files = parameters.outside.iter().map(file);
    uses("light/outside", files)
        + &format!("Outside outside_seen(vec3 wi) {{\n    return {value};\n}}\n")
}

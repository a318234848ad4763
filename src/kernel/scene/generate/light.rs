//! Explicit sampling of emitters.

use super::uses;
use crate::features::Features;
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

/// What is called for each kind of light: what its shape says, or `background`.
fn calls(
    features: &Features,
    of_shape: impl Fn(&Description) -> &str,
    background: &str,
) -> Vec<(u32, String)> {
    let call = |kind: LightKind| {
        let Some(shape) = kind.shape() else {
            return background.to_owned();
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
    let members = calls(features, |shape| shape.emission, "no_emission()");
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
    let members = calls(features, |shape| shape.emission_pdf, "0.0");
    let shapes = features.lights.iter().filter_map(|kind| kind.shape());
    let files = shapes.map(|shape| shape.description().emission_file);
    uses("light/emission/point", files)
        + &function("float", "emission_pdf", &arguments).text(&members, "0.0")
}

/// Explicit sampling: `light_sample`, and `light_pdf` for what a path hits.
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
    let samples = calls(features, |s| s.light_sample, "background_light_sample(u)");
    let pdfs = calls(features, |s| s.light_pdf, "background_light_pdf()");
    let none = "LightSample(vec3(0.0), -1.0, 0.0, 1.0, NONE)";
    let file = |kind: &LightKind| match kind.shape() {
        Some(shape) => shape.description().light_file,
        None => "light/background",
    };
    uses("light/sample", features.lights.iter().map(file))
        + &function("LightSample", "light_sample", &sample).text(&samples, none)
        + &function("float", "light_pdf", &pdf).text(&pdfs, "0.0")
}

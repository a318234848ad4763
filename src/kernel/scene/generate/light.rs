//! Explicit sampling of emitters.

use super::uses;
use crate::features::Features;
use crate::kernel::scene::dispatch::Dispatch;
use crate::prepared::LightKind;

fn light_file(kind: LightKind) -> &'static str {
    match kind {
        LightKind::Sphere => "sphere",
        LightKind::Box => "box",
        LightKind::Cylinder => "cylinder",
        LightKind::Mesh => "mesh",
        LightKind::Background => "background",
    }
}

/// Where light paths begin: `light_emission`.
pub fn emission(features: &Features) -> String {
    let first = "lights[light].first";
    let call = |kind: LightKind| match kind {
        LightKind::Sphere => {
            format!("sphere_emission(spheres[{first}].centre, spheres[{first}].radius, u)")
        }
        LightKind::Box => format!("box_emission(boxes[{first}].lo, boxes[{first}].hi, u24, u)"),
        LightKind::Cylinder => format!("cylinder_emission(cylinders[{first}], u24, u)"),
        LightKind::Mesh => {
            format!("mesh_emission({first}, lights[light].count, lights[light].cdf, u24, u)")
        }
        LightKind::Background => "no_emission()".into(),
    };
    let dispatch = Dispatch {
        result: "Emission",
        name: "light_emission",
        arguments: &[("uint", "light"), ("uint", "u24"), ("vec2", "u")],
        selector: "lights[light].kind",
    };
    let members: Vec<_> = (features.lights.iter())
        .map(|&k| (k as u32, call(k)))
        .collect();
    let shapes = (features.lights.iter()).filter(|&&k| k != LightKind::Background);
    let files = shapes.map(|&k| light_file(k));
    uses("light/emission/point", "light/emission", files)
        + &dispatch.text(&members, "no_emission()")
}

/// Explicit sampling: `light_sample`, and `light_pdf` for what a path hits.
pub fn light(features: &Features) -> String {
    let first = "lights[light].first";
    let (sphere, cuboid) = (format!("spheres[{first}]"), format!("boxes[{first}]"));
    let cylinder = format!("cylinders[{first}]");
    let sample = |kind: LightKind| match kind {
        LightKind::Sphere => {
            format!("sphere_light_sample(p, {sphere}.centre, {sphere}.radius, u)")
        }
        LightKind::Box => format!("box_light_sample(p, {cuboid}.lo, {cuboid}.hi, u24, u)"),
        LightKind::Cylinder => format!("cylinder_light_sample(p, {cylinder}, u24, u)"),
        LightKind::Mesh => {
            format!("mesh_light_sample(p, {first}, lights[light].count, lights[light].cdf, u24, u)")
        }
        LightKind::Background => "background_light_sample(u)".into(),
    };
    let pdf = |kind: LightKind| match kind {
        LightKind::Sphere => {
            format!("sphere_light_pdf(p, {sphere}.centre, {sphere}.radius, distance, cosine)")
        }
        LightKind::Box => {
            format!("box_light_pdf(p, {cuboid}.lo, {cuboid}.hi, distance, cosine)")
        }
        LightKind::Cylinder => format!("cylinder_light_pdf(p, {cylinder}, distance, cosine)"),
        LightKind::Mesh => {
            format!("mesh_light_pdf({first}, lights[light].cdf, prim, distance, cosine)")
        }
        LightKind::Background => "background_light_pdf()".into(),
    };
    let members = |call: &dyn Fn(LightKind) -> String| -> Vec<(u32, String)> {
        features
            .lights
            .iter()
            .map(|&k| (k as u32, call(k)))
            .collect()
    };
    let function = |result, name, arguments| Dispatch {
        result,
        name,
        arguments,
        selector: "lights[light].kind",
    };
    let sample_arguments = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "u24"),
        ("vec2", "u"),
    ];
    let pdf_arguments = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "prim"),
        ("float", "cosine"),
        ("float", "distance"),
    ];
    let none = "LightSample(vec3(0.0), -1.0, 0.0, NONE)";
    let files = features.lights.iter().map(|&k| light_file(k));
    uses("light/sample", "light", files)
        + &function("LightSample", "light_sample", &sample_arguments).text(&members(&sample), none)
        + &function("float", "light_pdf", &pdf_arguments).text(&members(&pdf), "0.0")
}

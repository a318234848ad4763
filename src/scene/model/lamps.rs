//! The lights of KHR_lights_punctual (docs/gltf.md, "Lights"): point lights become balls.

use std::f64::consts::PI;

use glam::DVec3;

use super::document::{Document, Light};
use super::left_out::LeftOut;
use super::legal::not_negative;
use crate::scene::mesh::gltf::{Placed, called};
use crate::scene::text::quote;

/// A ball that emits like a light at a node.
pub(super) struct Lamp {
    pub(super) centre: DVec3,
    pub(super) radius: f64,
    pub(super) radiance: DVec3,
    /// The light that it replaces.
    pub(super) light: usize,
    pub(super) node: String,
}

/// Lamps of `radius` for the nodes' point lights; other kinds of light go to `left_out`. Errors are messages.
pub(super) fn lamps(
    document: &Document,
    nodes: &[Placed],
    radius: f64,
    left_out: &mut LeftOut,
) -> Result<Vec<Lamp>, String> {
    let lights = lights(document);
    let mut lamps = Vec::new();
    for node in nodes {
        let own = document.nodes.get(node.number);
        let Some(asked) = own.and_then(|own| own.extensions.light.as_ref()) else {
            continue;
        };
        let light = lights.get(asked.light);
        let light =
            light.ok_or_else(|| format!("{}: light {} does not exist", node.label, asked.light))?;
        let label = label(document, asked.light);
        if light.kind != "point" {
            let kind = quote(&light.kind);
            left_out.note(
                format!("{kind} lights are not supported, so the picture lacks it: {INSTEAD}"),
                &label,
            );
            continue;
        }
        let radiance = radiance(light, radius).map_err(|what| format!("{label}: {what}"))?;
        let centre = node.to_scene.clone()?.translation;
        if !centre.as_vec3().is_finite() {
            return Err(format!(
                "{label}: its position is not finite in single precision"
            ));
        }
        if radiance != DVec3::ZERO {
            lamps.push(Lamp {
                centre,
                radius,
                radiance,
                light: asked.light,
                node: node.label.clone(),
            });
        }
    }
    Ok(lamps)
}

fn lights(document: &Document) -> &[Light] {
    let lights = document.extensions.lights.as_ref();
    lights.map_or(&[], |all| &all.lights)
}

/// The name of a light in messages.
pub(super) fn label(document: &Document, number: usize) -> String {
    let light = lights(document).get(number);
    called(
        "light",
        number,
        light.and_then(|light| light.name.as_deref()),
    )
}

const INSTEAD: &str = "use an emissive mesh or a point light";

/// A ball of radius r and radiance L has the intensity I = L π r² in all directions, because it is seen as a disc: L =
/// I/(π r²).
fn radiance(light: &Light, radius: f64) -> Result<DVec3, String> {
    let intensity = not_negative("intensity", light.intensity.unwrap_or(1.0))?;
    let [r, g, b] = light
        .color
        .unwrap_or([1.0; 3])
        .map(|x| not_negative("color", x));
    let radiance = intensity * DVec3::new(r?, g?, b?) / (PI * radius * radius);
    match radiance.as_vec3().is_finite() {
        true => Ok(radiance),
        false => Err("its radiance is not finite in single precision".to_owned()),
    }
}

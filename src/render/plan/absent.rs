//! Data that a kernel may look for although the scene lacks them; they are in no path. A kernel with exactly the
//! features that the scene needs gets the scene's own data.

use bytemuck::Zeroable;

use crate::features::Features;
use crate::flat;
use crate::layout::OnDevice;
use crate::prepared::{Coincidences, Light, LightKind, NONE, Prepared, Shape, device};

/// The scene's lights, and after them a dark one, if the kernel looks for it.
pub fn lights(prepared: &Prepared, features: &Features) -> Vec<device::Light> {
    let mut lights = flat::records(&prepared.lights);
    if looks_for_more(prepared, features) {
        lights.push(DARK);
    }
    lights
}

/// Their counts out of 2²⁴; the dark light has none, so that it is never chosen and its probability is 0.
pub fn light_cdf(prepared: &Prepared, features: &Features) -> Vec<u32> {
    let mut cdf = prepared.light_cdf.clone();
    if cdf.is_empty() {
        cdf.push(0);
    }
    if looks_for_more(prepared, features) {
        cdf.extend(cdf.last().copied());
    }
    cdf
}

/// The tree of lights: a leaf if the scene has none. The dark light is not in it.
pub fn light_tree(prepared: &Prepared, features: &Features) -> (Vec<device::LightNode>, Vec<u32>) {
    let mut nodes = flat::records(&prepared.light_tree.nodes);
    if nodes.is_empty() {
        nodes.push(device::LightNode {
            leaf: 1,
            ..Zeroable::zeroed()
        });
    }
    let mut trails = prepared.light_tree.trails.clone();
    if looks_for_more(prepared, features) {
        trails.push(0);
    }
    (nodes, trails)
}

/// The medium in which each light lies.
pub fn light_media(prepared: &Prepared, features: &Features) -> Vec<u32> {
    let mut media = prepared.light_media.clone();
    if looks_for_more(prepared, features) {
        media.push(NONE);
    }
    media
}

/// Index of the background among [`lights`]: the scene's, or the dark one.
pub fn background_light(prepared: &Prepared, features: &Features) -> Option<u32> {
    let own = prepared.lights.iter().position(is_outside);
    let dark = looks_for_more(prepared, features).then_some(prepared.lights.len());
    own.or(dark).map(|i| i as u32)
}

/// The kind of that light: the scene's, or that of [`DARK`]. `None` if the kernel has no light of that kind.
pub fn outside(prepared: &Prepared, features: &Features) -> Option<LightKind> {
    let own = background_light(prepared, features)?;
    let light = prepared.lights.get(own as usize);
    let kind = light.map_or(LightKind::Background, |light| light.kind);
    features.lights.contains(&kind).then_some(kind)
}

/// Surroundings for a scene that has none: a black picture of one texel.
pub const BLACK_TEXEL: device::Surroundings = device::Surroundings {
    x: [1.0, 0.0, 0.0],
    width: 1,
    y: [0.0, 1.0, 0.0],
    height: 1,
    z: [0.0, 0.0, 1.0],
    pad0: 0,
};

/// The row of [`BLACK_TEXEL`].
pub const BLACK_ROW: device::SurroundingsRow = device::SurroundingsRow {
    top: 0.0,
    bottom: 1.0,
    pdf: 0.0,
    end: 0,
};

/// The lens: for a pinhole one of radius 0, which adds 0 to the eye and to the points of pixels.
pub fn lens(prepared: &Prepared) -> device::Lens {
    prepared
        .lens
        .as_ref()
        .map_or(Zeroable::zeroed(), OnDevice::record)
}

/// The corners' shading normals: zeros if no mesh gives any, as for a mesh that gives none.
pub fn normals(prepared: &Prepared) -> Vec<[[f32; 3]; 3]> {
    let mut normals = flat::normals(prepared);
    normals.resize(prepared.primitives.triangles.len(), [[0.0; 3]; 3]);
    normals
}

/// Where the lists of coincident faces are: all empty if none coincide.
pub fn coincident_faces(prepared: &Prepared) -> Vec<u32> {
    let table = &prepared.primitives.coincident;
    match table.is_empty() {
        true => {
            let faces: Vec<_> = prepared.shapes.iter().map(Shape::faces).collect();
            Coincidences::new(&faces, Vec::new()).faces
        }
        false => table.faces.clone(),
    }
}

/// A background that emits nothing.
const DARK: device::Light = device::Light {
    radiance: [0.0; 3],
    kind: LightKind::Background as u32,
    shape: NONE,
    first: 0,
    count: 0,
    cdf: 0,
};

/// Whether the kernel uses lights, or a background, that the scene lacks.
fn looks_for_more(prepared: &Prepared, features: &Features) -> bool {
    let outside = features.lights.iter().any(|kind| kind.is_outside());
    let background = outside && !prepared.lights.iter().any(is_outside);
    background || (prepared.lights.is_empty() && !features.lights.is_empty())
}

fn is_outside(light: &Light) -> bool {
    light.kind.is_outside()
}

//! Notes the unsupported features of a document and its materials.

use super::document::{Document, Material, Primitive};
use super::left_out::LeftOut;
use crate::scene::mesh::gltf::called;
use crate::scene::text::quote;

/// Extensions that are read, or reported by `mesh::gltf`.
const READ: [&str; 3] = [
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",
];

/// Prefixes of extensions that are reported for each material, or that no picture needs.
const ELSEWHERE: [&str; 2] = ["KHR_materials_", "KHR_xmp"];

/// Notes the unsupported features of a document.
pub(super) fn note(document: &Document, left_out: &mut LeftOut) {
    const FILE: &str = "the file";
    let materials = document.materials.iter();
    let of_materials: Vec<_> = materials.flat_map(|m| m.extensions.others.keys()).collect();
    for name in &document.extensions_used {
        let elsewhere = ELSEWHERE.iter().any(|start| name.starts_with(start));
        if !READ.contains(&&**name) && !elsewhere && !of_materials.contains(&name) {
            left_out.note(format!("{} is not read", quote(name)), FILE);
        }
    }
    if !document.animations.is_empty() {
        let what = "its animations are not read: nodes and joints are in their rest pose";
        left_out.note(what, FILE);
    }
    let coloured = |p: &Primitive| p.attributes.keys().any(|name| name.starts_with("COLOR_"));
    for (number, mesh) in document.meshes.iter().enumerate() {
        if mesh.primitives.iter().any(coloured) {
            let label = called("mesh", number, mesh.name.as_deref());
            left_out.note("its vertex colours are not read", &label);
        }
    }
}

/// The suffix of the names of textures.
const TEXTURED: &str = "Texture";

/// Notes the unsupported features of a material.
pub(super) fn note_of_material(material: &Material, label: &str, left_out: &mut LeftOut) {
    let extensions = &material.extensions;
    let named = [
        &material.others,
        &material.pbr_metallic_roughness.others,
        &extensions.transmission.others,
        &extensions.volume.others,
        &extensions.specular.others,
    ];
    let names = named.into_iter().flat_map(|others| others.keys());
    for name in names.filter(|name| name.ends_with(TEXTURED)) {
        left_out.note(format!("its {} is not read", quote(name)), label);
    }
    for name in extensions.others.keys() {
        left_out.note(format!("{} is not read", quote(name)), label);
    }
    match material.alpha_mode.as_deref() {
        None | Some("OPAQUE") => {}
        Some(mode) => {
            let mode = quote(mode);
            left_out.note(
                format!("its alphaMode {mode} is not read: it is opaque"),
                label,
            );
        }
    }
}

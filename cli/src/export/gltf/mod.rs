//! glTF 2.0, as a GLB or as JSON with a separate buffer; vkpt's own reader converts it back to the same scene
//! (docs/gltf.md).

mod buffer;
mod camera;
mod container;
mod material;
mod materials;
mod reason;
mod shape;

pub use container::Container;
pub use reason::{Reason, setting};

use buffer::Buffer;
use materials::Materials;
use serde_json::{Value, json};

use super::remark::{Remark, gathered};
use super::{Export, Subject, Text};

/// The scene as glTF. [`setting`] must have accepted the model.
///
/// # Errors
/// Every feature without an equivalent in glTF, each reason once, in file order.
pub fn export(subject: &Subject, container: Container) -> Result<Export, Vec<Remark<Reason>>> {
    let mut refusals = camera::refusals(subject);
    let materials = Materials::of(subject, &mut refusals);
    let mut buffer = Buffer::default();
    let meshes = shape::meshes(subject, &materials, &mut buffer, &mut refusals);
    if meshes.is_empty() && refusals.is_empty() {
        refusals.push(Remark::new(subject.scene.camera_line, Reason::Nothing));
    }
    if container == Container::Glb && buffer.len() > Container::MOST {
        refusals.push(Remark::new(subject.scene.camera_line, Reason::Large));
    }
    if !refusals.is_empty() {
        return Err(gathered(refusals));
    }
    let (bytes, beside) = container.around(
        document(subject, materials, meshes, &buffer),
        buffer,
        subject.stem,
    );
    Ok(Export {
        text: Text::Bytes(bytes),
        beside: beside.into_iter().collect(),
        warnings: Vec::new(),
        note: camera::note(subject),
    })
}

/// Everything but the buffer itself.
fn document(
    subject: &Subject,
    materials: Materials,
    meshes: Vec<shape::Placed>,
    buffer: &Buffer,
) -> Value {
    let (meshes, places): (Vec<Value>, Vec<Value>) = meshes
        .into_iter()
        .map(|mesh| (mesh.mesh, mesh.node))
        .unzip();
    let nodes: Vec<Value> = [camera::node(subject)].into_iter().chain(places).collect();
    let roots: Vec<usize> = (0..nodes.len()).collect();
    let (materials, extensions) = materials.into_json();
    let mut document = json!({
        "asset": { "version": "2.0", "generator": concat!("vkpt ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": roots }],
        "nodes": nodes,
        "cameras": [camera::camera(subject)],
        "materials": materials,
        "meshes": meshes,
        "accessors": buffer.accessors(),
        "bufferViews": buffer.views(),
    });
    // A list may be omitted, but not empty.
    if !extensions.is_empty() {
        document["extensionsUsed"] = json!(extensions);
    }
    document
}

//! glTF 2.0 and GLB (Khronos, *glTF 2.0 Specification*, 2021), over the JSON types of `gltf`.
//!
//! All triangles of the default scene are one mesh, each node's placed by its transform; without a default scene
//! those of the first, without any scene those of all nodes. Points and lines are skipped, materials and
//! pictures are not looked at. A skinned mesh is read as it was bound, morph targets are left at 0.
//!
//! That crate's own walk through a document panics where an index leads nowhere; so here each one is looked up.

mod accessors;
mod assembly;
mod buffers;
mod nodes;
mod primitive;

use std::borrow::Cow;
use std::path::Path;

use gltf::json::{Root, deserialize};

use super::{MeshError, MeshFile};
use crate::scene::text::quote;
use accessors::Accessors;
use assembly::Assembly;

/// More vertices or corners than this, in all instances together, are refused: a file of a few lines can ask for
/// any number of them.
const MOST: u64 = 1 << 26;

/// Extensions that a file may require: they change what is not read, or the type of numbers only.
const HARMLESS: [&str; 9] = [
    "KHR_mesh_quantization",
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_animation_",
    "KHR_xmp",
    "EXT_texture_",
    "EXT_lights_",
    "MSFT_texture_",
];

/// Reads the whole file `bytes`, and the buffers beside it in `folder`.
pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<MeshFile, MeshError> {
    let (json, bin) = split(bytes)?;
    let root: Root = deserialize::from_slice(&json)
        .map_err(|error| MeshError::Malformed(format!("its JSON is not understood: {error}")))?;
    for name in &root.extensions_required {
        if !HARMLESS.iter().any(|start| name.starts_with(start)) {
            let name = quote(name);
            return Err(MeshError::Malformed(format!(
                "it requires the extension `{name}`, which is not read"
            )));
        }
    }
    let (buffers, files) =
        buffers::load(&root, bin.as_deref(), folder).map_err(MeshError::Malformed)?;
    let accessors = Accessors::new(&root, &buffers);
    let nodes = nodes::placed(&root).map_err(MeshError::Malformed)?;
    let asked = nodes.iter().map(|(node, _)| primitive::asked(node, &root));
    if asked.fold(0, u64::saturating_add) > MOST {
        return Err(MeshError::Malformed(format!(
            "its nodes together ask for more than {MOST} vertices or corners"
        )));
    }
    let mut assembly = Assembly::default();
    for (node, to_scene) in nodes {
        assembly
            .add(node, to_scene, &root, &accessors)
            .map_err(MeshError::Malformed)?;
    }
    assembly.finish(files)
}

/// The JSON, and the binary chunk of a GLB.
#[expect(clippy::type_complexity, reason = "two kinds of bytes")]
fn split(bytes: &[u8]) -> Result<(Cow<'_, [u8]>, Option<Cow<'_, [u8]>>), MeshError> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes.into(), None));
    }
    // Magic number, version, length of the file; the crate subtracts before it compares.
    let claimed = match bytes {
        [_, _, _, _, _, _, _, _, a, b, c, d, ..] => u32::from_le_bytes([*a, *b, *c, *d]) as usize,
        _ => 0,
    };
    if claimed < 12 || claimed > bytes.len() {
        return Err(MeshError::Malformed(format!(
            "it is truncated: it claims {claimed} bytes, and has {}",
            bytes.len()
        )));
    }
    let glb = gltf::Glb::from_slice(&bytes[..claimed])
        .map_err(|error| MeshError::Malformed(error.to_string()))?;
    Ok((glb.json, glb.bin))
}

//! glTF 2.0 and GLB (Khronos, *glTF 2.0 Specification*, 2021).
//!
//! All triangles of the default scene are one mesh, each node's placed by its transform, or by the joints that it is bound
//! to; without a default scene those of the first, without any scene those of all nodes. Points and lines are skipped,
//! materials and pictures are not looked at. Animations are not read: joints stand as their nodes have them, morph targets
//! are left at 0.
//!
//! No index is trusted: each one is looked up.

mod accessors;
mod address;
mod assembly;
mod binding;
mod buffers;
mod component;
mod container;
mod document;
mod nodes;
mod primitive;
mod requirements;
mod scenes;
mod skin;
mod topology;

use std::path::Path;

use super::{MeshError, MeshFile};
use accessors::Accessors;
use assembly::Assembly;
use buffers::Buffers;
use document::Document;
use nodes::Nodes;

/// More vertices or corners than this, in all instances together, are refused: a file of a few lines can ask for
/// any number of them.
const MOST: u64 = 1 << 26;

/// Reads the whole file `bytes`, and the buffers beside it in `folder`.
pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<MeshFile, MeshError> {
    let container = container::open(bytes).map_err(MeshError::Malformed)?;
    let document = understood(&container.json).map_err(MeshError::Malformed)?;
    let buffers = Buffers::load(&document, container.bin, folder).map_err(MeshError::Malformed)?;
    let (assembly, warning) = assembled(&document, &buffers).map_err(MeshError::Malformed)?;
    assembly.finish(buffers.into_files(), warning.into_iter().collect())
}

/// The document, if all is read that it requires.
fn understood(json: &str) -> Result<Document, String> {
    requirements::version(json)?;
    let document: Document =
        serde_json::from_str(json).map_err(|error| requirements::not_understood(&error))?;
    requirements::extensions(&document.extensions_required)?;
    Ok(document)
}

/// The meshes of all nodes that are read, and a warning where those are others than the file asks for.
fn assembled(document: &Document, buffers: &Buffers) -> Result<(Assembly, Option<String>), String> {
    let accessors = Accessors { document, buffers };
    let mut nodes = Nodes::of(document)?;
    let (shown, warning) = scenes::shown(document, &nodes)?;
    let asked = shown
        .iter()
        .map(|node| primitive::asked(&document.nodes[*node], document));
    if asked.fold(0, u64::saturating_add) > MOST {
        return Err(format!(
            "its nodes together ask for more than {MOST} vertices or corners"
        ));
    }
    let mut assembly = Assembly::default();
    for node in shown {
        assembly.add(node, document, &accessors, &mut nodes)?;
    }
    Ok((assembly, warning))
}

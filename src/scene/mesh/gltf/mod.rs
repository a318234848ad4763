//! glTF 2.0 and GLB (Khronos, *glTF 2.0 Specification*, 2021).
//!
//! All triangles of the default scene form one mesh, each node's placed by its transform or by its joints; without a
//! default scene, those of the first scene; without any scene, those of all nodes. Points and lines are skipped,
//! materials and pictures ignored. Animations are not read: joints stay at their nodes' transforms, morph weights at 0.
//!
//! No index is trusted: each one is checked.

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

use glam::DAffine3;

use super::{MeshError, MeshFile};
use accessors::Accessors;
use assembly::Assembly;
pub(in crate::scene) use assembly::Part;
use buffers::Buffers;
use document::Document;
pub(in crate::scene) use document::called;
use nodes::Nodes;
pub(in crate::scene) use requirements::not_understood;

/// Files with more vertices or corners, counting all instances, are refused: a file of a few lines can request any
/// number.
const MOST: u64 = 1 << 26;

/// Reads the complete file `bytes`, and the external buffers in `folder`.
pub(super) fn read(bytes: &[u8], folder: &Path) -> Result<MeshFile, MeshError> {
    let container = container::open(bytes).map_err(MeshError::Malformed)?;
    let document = understood(&container.json).map_err(MeshError::Malformed)?;
    let buffers = Buffers::load(&document, container.bin, folder).map_err(MeshError::Malformed)?;
    let together = assembled(&document, &buffers).map_err(MeshError::Malformed)?;
    let warning = together.warning.into_iter().collect();
    together.assembly.finish(buffers.into_files(), warning)
}

/// A file as needed for a scene.
pub(in crate::scene) struct Whole {
    /// The complete JSON.
    pub(in crate::scene) json: String,
    /// All triangles together, and the range of each primitive that has any.
    pub(in crate::scene) mesh: MeshFile,
    pub(in crate::scene) parts: Vec<Part>,
    /// The nodes that are read, parents before children.
    pub(in crate::scene) nodes: Vec<Placed>,
}

/// A node and its transform.
pub(in crate::scene) struct Placed {
    pub(in crate::scene) number: usize,
    /// Its name in messages.
    pub(in crate::scene) label: String,
    /// Its transform to the scene's space, or the error in it.
    pub(in crate::scene) to_scene: Result<DAffine3, String>,
}

/// Like [`read`], but keeps primitives and nodes separate.
pub(in crate::scene) fn read_whole(bytes: &[u8], folder: &Path) -> Result<Whole, MeshError> {
    let container = container::open(bytes).map_err(MeshError::Malformed)?;
    let document = understood(&container.json).map_err(MeshError::Malformed)?;
    let buffers = Buffers::load(&document, container.bin, folder).map_err(MeshError::Malformed)?;
    let mut together = assembled(&document, &buffers).map_err(MeshError::Malformed)?;
    let mut parts = together.assembly.take_parts();
    parts.retain(|part| !part.triangles.is_empty());
    let mut placed = |number| Placed {
        number,
        label: together.nodes.label(number),
        to_scene: together.nodes.placed(number),
    };
    let nodes = together.shown.iter().map(|n| placed(*n)).collect();
    let warning = together.warning.into_iter().collect();
    let mesh = together.assembly.finish(buffers.into_files(), warning)?;
    let json = container.json.into_owned();
    Ok(Whole {
        json,
        mesh,
        parts,
        nodes,
    })
}

/// The document, if everything that it requires is supported.
fn understood(json: &str) -> Result<Document, String> {
    requirements::version(json)?;
    let document: Document =
        serde_json::from_str(json).map_err(|error| requirements::not_understood(&error))?;
    requirements::extensions(&document.extensions_required)?;
    Ok(document)
}

/// The meshes of all nodes that are read.
struct Together<'d> {
    assembly: Assembly,
    nodes: Nodes<'d>,
    shown: Vec<usize>,
    /// A warning if these are not the nodes that the file specifies.
    warning: Option<String>,
}

fn assembled<'d>(document: &'d Document, buffers: &Buffers) -> Result<Together<'d>, String> {
    let accessors = Accessors { document, buffers };
    let mut nodes = Nodes::of(document)?;
    let (shown, warning) = scenes::shown(document, &nodes)?;
    let asked = shown
        .iter()
        .map(|node| primitive::asked(&document.nodes[*node], document));
    if asked.fold(0, u64::saturating_add) > MOST {
        return Err(format!(
            "its nodes together have more than {MOST} vertices or corners"
        ));
    }
    let mut assembly = Assembly::default();
    for node in &shown {
        assembly.add(*node, document, &accessors, &mut nodes)?;
    }
    Ok(Together {
        assembly,
        nodes,
        shown,
        warning,
    })
}

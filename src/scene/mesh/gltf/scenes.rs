//! Selects the nodes to read.

use std::collections::HashSet;
use std::iter::once;

use super::document::{Document, called};
use super::nodes::Nodes;

/// The nodes to read, parents before children: those of the default scene, or the first; if these have no triangles,
/// those of the first scene that has some, with a warning. Without any scene, all nodes. Errors are messages.
pub(super) fn shown(
    document: &Document,
    nodes: &Nodes,
) -> Result<(Vec<usize>, Option<String>), String> {
    let scenes = &document.scenes;
    let first = document.scene.unwrap_or(0);
    if document.scene.is_some() && first >= scenes.len() {
        return Err("its default scene does not exist".into());
    }
    if scenes.is_empty() {
        return Ok((below(nodes.roots(), nodes)?, None));
    }
    let others = (0..scenes.len()).filter(|scene| *scene != first);
    for number in once(first).chain(others) {
        let scene = &scenes[number];
        let shown = below(scene.nodes.iter().copied(), nodes)?;
        if shown.iter().any(|node| has_triangles(*node, document)) {
            let warning = || {
                let [first, read] = [first, number]
                    .map(|scene| called("scene", scene, scenes[scene].name.as_deref()));
                format!("{first} has no triangles: {read} is read instead")
            };
            return Ok((shown, (number != first).then(warning)));
        }
    }
    Ok((Vec::new(), None))
}

/// Nodes with all their descendants.
///
/// A node that is reached twice is refused, as the format requires: it may be its own ancestor.
fn below(tops: impl Iterator<Item = usize>, nodes: &Nodes) -> Result<Vec<usize>, String> {
    let mut to_visit: Vec<usize> = tops.collect();
    to_visit.reverse();
    let mut seen = HashSet::new();
    let mut found = Vec::new();
    while let Some(number) = to_visit.pop() {
        let node = nodes.get(number)?;
        if !seen.insert(number) {
            let node = nodes.label(number);
            return Err(format!("{node} is in its scene twice"));
        }
        found.push(number);
        to_visit.extend(node.children.iter().flatten().rev());
    }
    Ok(found)
}

/// Has a mesh of triangles, or a missing mesh, which must be reported.
fn has_triangles(node: usize, document: &Document) -> bool {
    let Some(mesh) = document.nodes[node].mesh else {
        return false;
    };
    let mesh = document.meshes.get(mesh);
    mesh.is_none_or(|mesh| mesh.primitives.iter().any(|p| p.has_triangles()))
}

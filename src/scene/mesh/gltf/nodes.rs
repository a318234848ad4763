//! The nodes of a scene and where they stand.

use glam::{DAffine3, DMat4, DQuat, DVec3};
use gltf::json::{Index, Node, Root};

/// The nodes of the scene that is read, parents before children, each with its transform to the scene's space; an
/// error says what is wrong.
///
/// A node that is reached twice is refused, as the format does: it may be its own ancestor, or be reached in
/// exponentially many ways.
pub(super) fn placed(root: &Root) -> Result<Vec<(&Node, DAffine3)>, String> {
    let mut to_visit: Vec<_> = tops(root)?
        .into_iter()
        .rev()
        .map(|node| (node, DAffine3::IDENTITY))
        .collect();
    let mut seen = vec![false; root.nodes.len()];
    let mut placed = Vec::new();
    while let Some((index, parent)) = to_visit.pop() {
        let number = index.value();
        let node = root
            .get(index)
            .ok_or_else(|| format!("there is no node {number}"))?;
        if std::mem::replace(&mut seen[number], true) {
            return Err(format!("node {number} stands in its scene twice"));
        }
        let to_scene = parent
            * local(node).ok_or_else(|| {
                format!("the matrix of node {number} has another last row than 0 0 0 1")
            })?;
        placed.push((node, to_scene));
        let children = node.children.iter().flatten().rev();
        to_visit.extend(children.map(|child| (*child, to_scene)));
    }
    Ok(placed)
}

/// The nodes that have no parent in the default scene, or the first, or, where there is none, in the file.
fn tops(root: &Root) -> Result<Vec<Index<Node>>, String> {
    let scene = match root.scene {
        Some(scene) => Some(root.get(scene).ok_or("its default scene is not there")?),
        None => root.scenes.first(),
    };
    if let Some(scene) = scene {
        return Ok(scene.nodes.clone());
    }
    let children = root.nodes.iter().filter_map(|node| node.children.as_ref());
    let mut is_child = vec![false; root.nodes.len()];
    for child in children.flatten() {
        if let Some(is_child) = is_child.get_mut(child.value()) {
            *is_child = true;
        }
    }
    let tops = is_child.iter().enumerate().filter(|(_, child)| !**child);
    Ok(tops.map(|(i, _)| Index::new(i as u32)).collect())
}

/// The transform to the parent's space: a matrix (column-major), or T·R·S; `None` where it is not affine.
fn local(node: &Node) -> Option<DAffine3> {
    if let Some(matrix) = node.matrix {
        let matrix = DMat4::from_cols_array(&matrix.map(f64::from));
        let affine = matrix.row(3).to_array() == [0.0, 0.0, 0.0, 1.0];
        return affine.then(|| DAffine3::from_mat4(matrix));
    }
    let vector = |v: Option<[f32; 3]>, or: DVec3| v.map_or(or, |v| DVec3::from(v.map(f64::from)));
    let rotation = node.rotation.unwrap_or_default().0.map(f64::from);
    Some(DAffine3::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        DQuat::from_array(rotation).normalize(),
        vector(node.translation, DVec3::ZERO),
    ))
}

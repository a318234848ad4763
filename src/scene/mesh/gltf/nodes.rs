//! Transforms of nodes.

use std::iter;

use glam::{DAffine3, DMat4, DQuat, DVec3};

use super::document::{Document, Node, called};

/// A document's nodes and their transforms to the scene's space, each computed once.
pub(super) struct Nodes<'a> {
    all: &'a [Node],
    parents: Vec<Option<usize>>,
    known: Vec<Option<DAffine3>>,
}

impl<'a> Nodes<'a> {
    /// Errors are messages: a node with two parents would have two transforms.
    pub(super) fn of(document: &'a Document) -> Result<Self, String> {
        let all = &document.nodes;
        let mut parents = vec![None; all.len()];
        for (parent, node) in all.iter().enumerate() {
            for child in node.children.iter().flatten() {
                let of_child = parents.get_mut(*child);
                let of_child = of_child.ok_or_else(|| format!("node {child} does not exist"))?;
                if of_child.replace(parent).is_some() {
                    let child = label(all, *child);
                    return Err(format!("{child} is listed as a child twice"));
                }
            }
        }
        let known = vec![None; all.len()];
        Ok(Self {
            all,
            parents,
            known,
        })
    }

    /// The name of a node in messages.
    pub(super) fn label(&self, number: usize) -> String {
        label(self.all, number)
    }

    /// A node; an error if it does not exist.
    pub(super) fn get(&self, number: usize) -> Result<&'a Node, String> {
        let node = self.all.get(number);
        node.ok_or_else(|| format!("node {number} does not exist"))
    }

    /// The nodes that have no parent.
    pub(super) fn roots(&self) -> impl Iterator<Item = usize> {
        (0..self.all.len()).filter(|node| self.parents[*node].is_none())
    }

    /// The transform of a node to the scene's space, whether or not a scene contains it: the product of its ancestors'
    /// and its own (glTF 2.0, section 3.5.3, *Transformations*). Errors are messages.
    pub(super) fn placed(&mut self, number: usize) -> Result<DAffine3, String> {
        self.get(number)?;
        // The chain from the node up to the first known ancestor.
        let mut unknown = Vec::new();
        let mut next = Some(number);
        while let Some(node) = next.filter(|node| self.known[*node].is_none()) {
            if unknown.len() == self.all.len() {
                return Err(format!("{} is its own ancestor", self.label(node)));
            }
            unknown.push(node);
            next = self.parents[node];
        }
        let mut to_scene = next.and_then(|node| self.known[node]).unwrap_or_default();
        for node in unknown.into_iter().rev() {
            let own = local(&self.all[node])
                .map_err(|(what, is)| format!("the {what} of {} {is}", self.label(node)))?;
            to_scene *= own;
            if !to_scene.is_finite() {
                let node = self.label(node);
                return Err(format!(
                    "the transform of {node} to its scene is not finite"
                ));
            }
            self.known[node] = Some(to_scene);
        }
        Ok(to_scene)
    }

    /// The nearest node, starting with this one and going up, whose transform flattens everything below it.
    pub(super) fn flat(&self, number: usize) -> Option<usize> {
        let singular = |node: &usize| {
            local(&self.all[*node]).is_ok_and(|own| own.matrix3.determinant() == 0.0)
        };
        iter::successors(Some(number), |node| self.parents[*node]).find(singular)
    }
}

fn label(all: &[Node], number: usize) -> String {
    let name = all.get(number).and_then(|node| node.name.as_deref());
    called("node", number, name)
}

/// The transform to the parent's space: a matrix, or T·R·S; or which of them is wrong, and how.
fn local(node: &Node) -> Result<DAffine3, (&'static str, &'static str)> {
    if let Some(matrix) = &node.matrix {
        let matrix = DMat4::from_cols_array(&finite("matrix", matrix)?);
        return match matrix.row(3).to_array() {
            [0.0, 0.0, 0.0, 1.0] => Ok(DAffine3::from_mat4(matrix)),
            _ => Err(("matrix", "has a last row other than 0 0 0 1")),
        };
    }
    let rotation = finite("rotation", &node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]))?;
    let rotation = DQuat::from_array(rotation);
    if rotation.length() == 0.0 {
        return Err(("rotation", "is zero"));
    }
    Ok(DAffine3::from_scale_rotation_translation(
        DVec3::from(finite("scale", &node.scale.unwrap_or([1.0; 3]))?),
        rotation.normalize(),
        DVec3::from(finite(
            "translation",
            &node.translation.unwrap_or_default(),
        )?),
    ))
}

/// The numbers unchanged, if they are finite in single precision, in which the format defines them.
fn finite<const N: usize>(
    what: &'static str,
    numbers: &[f64; N],
) -> Result<[f64; N], (&'static str, &'static str)> {
    match numbers.iter().all(|x| (*x as f32).is_finite()) {
        true => Ok(*numbers),
        false => Err((what, "is not finite in single precision")),
    }
}

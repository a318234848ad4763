//! The kernels' bounding volume hierarchy: eight children per node, 80 bytes per node.
//!
//! Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017. Twin:
//! `shaders/shape/bvh/`, which reads these words.

mod cost;
mod leaf;
mod quantise;
pub mod reference;
mod topology;

use obvhs::cwbvh::node::CwBvhNode;
use rayon::prelude::*;

use crate::prepared::{Prepared, ShapeKind};
use crate::shape::Extent;
pub use cost::Cost;
pub use leaf::leaf_text;
use quantise::{Grid, Planes};

/// 32-bit words per node.
pub const NODE_WORDS: usize = 20;

/// A hierarchy in the kernels' format.
///
/// Words of a node: 0–2 origin of its grid (`f32`); 3 exponents of x, y, z and the mask of inner children (a byte
/// each); 4 first inner child; 5 first reference; 6–7 one byte per child: inner 0b001·11·slot, leaf: unary count and
/// offset of its references, absent 0; 8–11, 12–15, 16–19 planes of x, y, z: one byte per child, eight lower ones, then
/// eight upper ones. Inner children of a node are consecutive in `nodes`, in slot order.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    pub nodes: Vec<[u32; NODE_WORDS]>,
    /// The references of leaves, see [`reference::encode`].
    pub references: Vec<u32>,
    /// Maximum number of entries on a traversal's stack; at least 1, because it is the length of an array in GLSL.
    pub stack: u32,
    /// The largest absolute coordinate of any primitive.
    pub reach: f32,
    pub cost: Cost,
}

/// The hierarchy of all primitives of the given kinds. The result has the same bits on any number of cores.
pub fn build(prepared: &Prepared, kinds: &[ShapeKind]) -> Bvh {
    let references = reference::references(prepared, kinds);
    let bounds: Vec<Extent> = references
        .par_iter()
        .map(|&r| {
            let (kind, i) = reference::decode(r);
            Extent::around(prepared.primitives.get(kind, i).extent_in_f32())
        })
        .collect();
    over(&references, &bounds)
}

/// The hierarchy of `references`; `bounds` has their boxes in the same order.
fn over(references: &[u32], bounds: &[Extent]) -> Bvh {
    if references.is_empty() {
        // One node without children: a traversal ends immediately.
        return Bvh {
            nodes: vec![[0; NODE_WORDS]],
            references: Vec::new(),
            stack: 1,
            reach: 0.0,
            cost: Cost::default(),
        };
    }
    let tree = topology::topology(bounds);
    let order = &tree.primitive_indices;
    let bounds: Vec<Extent> = order.par_iter().map(|&i| bounds[i as usize]).collect();
    let boxes = node_bounds(&tree.nodes, &bounds);
    let node = |(i, node): (usize, &CwBvhNode)| {
        words(node, boxes[i], &child_bounds(node, &boxes, &bounds))
    };
    let root = boxes[0];
    Bvh {
        nodes: tree.nodes.par_iter().enumerate().map(node).collect(),
        references: order.iter().map(|&i| references[i as usize]).collect(),
        stack: stack_bound(&tree.nodes).max(1),
        reach: root.reach(),
        cost: Cost::of(&tree.nodes, &boxes, |node| {
            child_bounds(node, &boxes, &bounds)
        }),
    }
}

/// The exact box of every node. Children come after their parents, so one pass from the end suffices.
fn node_bounds(nodes: &[CwBvhNode], primitives: &[Extent]) -> Vec<Extent> {
    let mut boxes = vec![Extent::EMPTY; nodes.len()];
    for (i, node) in nodes.iter().enumerate().rev() {
        boxes[i] = child_bounds(node, &boxes, primitives)
            .into_iter()
            .flatten()
            .collect();
    }
    boxes
}

/// The boxes of a node's children by slot.
fn child_bounds(node: &CwBvhNode, boxes: &[Extent], primitives: &[Extent]) -> [Option<Extent>; 8] {
    std::array::from_fn(|slot| {
        if node.is_child_empty(slot) {
            None
        } else if node.is_leaf(slot) {
            let (first, count) = node.child_primitives(slot);
            let range = first as usize..(first + count) as usize;
            Some(primitives[range].iter().copied().collect())
        } else {
            Some(boxes[node.child_node_index(slot) as usize])
        }
    })
}

/// A node's words: shape and order from `node`, planes from its children's exact boxes.
fn words(node: &CwBvhNode, bounds: Extent, children: &[Option<Extent>; 8]) -> [u32; NODE_WORDS] {
    let grid = Grid::covering(bounds);
    let planes = children.map(|c| c.map_or(Planes::default(), |b| grid.planes(b)));
    let [ex, ey, ez] = grid.exponent;
    let four = |byte: &dyn Fn(usize) -> u8| u32::from_le_bytes(std::array::from_fn(byte));
    let mut words = [0; NODE_WORDS];
    words[..3].copy_from_slice(&grid.origin.map(f32::to_bits));
    words[3] = u32::from_le_bytes([ex, ey, ez, node.imask]);
    words[4] = node.child_base_idx;
    words[5] = node.primitive_base_idx;
    for half in 0..2 {
        words[6 + half] = four(&|i| node.child_meta[4 * half + i]);
        for axis in 0..3 {
            words[8 + 4 * axis + half] = four(&|i| planes[4 * half + i].lo[axis]);
            words[10 + 4 * axis + half] = four(&|i| planes[4 * half + i].hi[axis]);
        }
    }
    words
}

/// Bound on the stack: the traversal enters one child and pushes the others, if any, as one entry. So a path from the
/// root costs one entry for every node with two or more inner children.
fn stack_bound(nodes: &[CwBvhNode]) -> u32 {
    let mut bound = vec![0; nodes.len()];
    for (i, node) in nodes.iter().enumerate().rev() {
        let inner = node.imask.count_ones();
        let first = node.child_base_idx as usize;
        let deepest = bound[first..first + inner as usize].iter().max();
        bound[i] = deepest.unwrap_or(&0) + u32::from(inner > 1);
    }
    bound[0]
}

//! A binary tree of boxes over numbered primitives, read-only once built.

use glam::DVec3;

use super::slabs::Slabs;
use super::split::{Item, split};
use crate::reference::math::{Real, Vec3};
use crate::shape::Bounds;

/// Primitives that a leaf may hold.
const LEAF: usize = 4;
/// From this depth on sets are halved by count, which ends within 32 more levels.
const HALVING_DEPTH: usize = 40;
/// One waiting sibling a level.
const STACK: usize = HALVING_DEPTH + 32;

/// A bounding volume hierarchy.
pub struct Tree<F> {
    nodes: Vec<Node<F>>,
    /// Primitives in the order of leaves.
    order: Vec<u32>,
    /// The largest absolute coordinate.
    reach: F,
}

#[derive(Clone, Copy, Debug)]
struct Node<F> {
    lo_hi: [Vec3<F>; 2],
    /// Its first place in `order`, or the first of its two neighbouring children.
    first: u32,
    /// Primitives of a leaf; 0: an inner node.
    count: u32,
}

impl<F: Real> Tree<F> {
    /// The tree over primitives 0 … n − 1 within `bounds`. One thread, no randomness: always the same tree.
    pub fn new(bounds: &[Bounds]) -> Self {
        let mut items: Vec<Item> = (0..)
            .zip(bounds)
            .map(|(primitive, &bounds)| Item { bounds, primitive })
            .collect();
        let nodes = if items.is_empty() {
            Vec::new()
        } else {
            nodes(&mut items)
        };
        let all = bounds
            .iter()
            .copied()
            .fold(Bounds::point(DVec3::ZERO), Bounds::union);
        Self {
            nodes,
            order: items.iter().map(|item| item.primitive).collect(),
            reach: F::new((-all.lo).max(all.hi).max_element()),
        }
    }

    /// Visits every primitive whose hit could be at `t_max` or nearer on the ray o + t d, |d| = 1; nearer boxes
    /// first. `visit` gets the primitive and returns the new `t_max`, the distance of the nearest hit so far.
    pub fn traverse(&self, o: Vec3<F>, d: Vec3<F>, mut t_max: F, mut visit: impl FnMut(u32) -> F) {
        let slabs = Slabs::new(o, d, self.reach);
        let mut stack = [Met {
            node: 0,
            entry: t_max,
        }; STACK];
        let mut waiting = 0;
        let mut next = self.meet(0, &slabs, t_max);
        while let Some(met) = next {
            let node = &self.nodes[met.node as usize];
            next = if node.count > 0 {
                for place in node.first..node.first + node.count {
                    t_max = visit(self.order[place as usize]);
                }
                None
            } else {
                let (near, far) = self.children(node.first, &slabs, t_max);
                if let Some(far) = far {
                    stack[waiting] = far;
                    waiting += 1;
                }
                near
            };
            while next.is_none() && waiting > 0 {
                waiting -= 1;
                next = (stack[waiting].entry <= t_max).then_some(stack[waiting]);
            }
        }
    }

    /// The box of a node, if the ray enters it before or at `t_max`.
    #[inline]
    fn meet(&self, node: u32, slabs: &Slabs<F>, t_max: F) -> Option<Met<F>> {
        let entry = slabs.entry(&self.nodes.get(node as usize)?.lo_hi, t_max)?;
        Some(Met { node, entry })
    }

    /// Of the two children from `first` on those that are met, the nearer one first.
    fn children(&self, first: u32, slabs: &Slabs<F>, t_max: F) -> (Option<Met<F>>, Option<Met<F>>) {
        let (a, b) = (
            self.meet(first, slabs, t_max),
            self.meet(first + 1, slabs, t_max),
        );
        match (a, b) {
            (Some(a), Some(b)) if b.entry < a.entry => (Some(b), Some(a)),
            (None, b) => (b, None),
            both => both,
        }
    }
}

/// A node whose box a ray enters, and where.
#[derive(Clone, Copy)]
struct Met<F> {
    node: u32,
    entry: F,
}

impl<F: Real> Node<F> {
    /// A leaf of `items`, which begin at place `first`.
    fn over(items: &[Item], first: usize) -> Self {
        let bounds = items
            .iter()
            .fold(Bounds::EMPTY, |all, item| all.union(item.bounds));
        Self {
            lo_hi: [bounds.lo, bounds.hi].map(Vec3::new),
            first: first as u32,
            count: items.len() as u32,
        }
    }
}

/// The nodes over `items`, the root first, and `items` in the order of leaves.
fn nodes<F: Real>(items: &mut [Item]) -> Vec<Node<F>> {
    let mut nodes = vec![Node::over(items, 0)];
    // (node, its range of items, its depth)
    let mut open = vec![(0, 0..items.len(), 0)];
    while let Some((node, range, depth)) = open.pop() {
        if range.len() <= LEAF {
            continue;
        }
        let part = &mut items[range.clone()];
        let count = if depth < HALVING_DEPTH {
            split(part)
        } else {
            part.len() / 2
        };
        let middle = range.start + count;
        let children = nodes.len();
        (nodes[node].first, nodes[node].count) = (children as u32, 0);
        for (i, half) in [range.start..middle, middle..range.end]
            .into_iter()
            .enumerate()
        {
            nodes.push(Node::over(&items[half.clone()], half.start));
            open.push((children + i, half, depth + 1));
        }
    }
    nodes
}

//! Builds nodes and leaves over primitives, top down and on all cores; the result never depends on the threads.

use rayon::prelude::*;

use super::leaf::Leaf;
use super::node::{Child, Node};
use super::split::{Item, split};
use crate::reference::math::Real;
use crate::reference::math::lanes::WIDTH;
use crate::reference::primitives::Primitives;
use crate::shape::Extent;

/// The most primitives in a leaf.
const LEAF: usize = WIDTH;
/// From this depth on sets are halved by count: by eight a level, which ends within 11 more.
const HALVING_DEPTH: usize = 24;
/// The most levels of a tree.
pub const DEPTH: usize = HALVING_DEPTH + 11;
/// Larger sets are built in parallel.
const SERIAL: usize = 4096;

/// A tree or a part of one.
pub struct Built<F> {
    pub nodes: Vec<Node>,
    pub leaves: Vec<Leaf<F>>,
}

/// All primitives, in the order of their numbers.
pub fn items<F: Real>(primitives: &Primitives<F>) -> Vec<Item> {
    let item = |(primitive, bounds)| Item {
        extent: Extent::around(bounds),
        primitive,
    };
    (0..).zip(primitives.extents()).map(item).collect()
}

/// The primitives of one child, and the box around them.
struct Set<'a> {
    items: &'a mut [Item],
    extent: Extent,
}

impl<'a> Set<'a> {
    fn new(items: &'a mut [Item]) -> Self {
        let extent = items.iter().map(|item| item.extent).collect();
        Self { items, extent }
    }
}

impl<F: Real> Built<F> {
    /// An empty tree.
    pub fn new() -> Self {
        Self {
            nodes: Vec::new(),
            leaves: Vec::new(),
        }
    }

    /// Adds the nodes and leaves over `items`, at least one, and returns their top.
    pub fn add(&mut self, primitives: &Primitives<F>, items: &mut [Item], depth: usize) -> Child {
        if items.len() <= LEAF {
            let numbers = items.iter().map(|item| item.primitive);
            self.leaves.push(Leaf::new(primitives, numbers));
            return Child::Leaf(self.leaves.len() as u32 - 1);
        }
        let parallel = items.len() > SERIAL;
        let at = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let sets = sets(items, depth);
        let extents: Vec<Extent> = sets.iter().map(|set| set.extent).collect();
        let children: Vec<Child> = if parallel {
            let part = |set: Set| {
                let mut part = Self::new();
                (part.add(primitives, set.items, depth + 1), part)
            };
            let parts: Vec<_> = sets.into_par_iter().map(part).collect();
            parts.into_iter().map(|part| self.append(part)).collect()
        } else {
            let add = |set: Set| self.add(primitives, set.items, depth + 1);
            sets.into_iter().map(add).collect()
        };
        for (i, (extent, child)) in extents.into_iter().zip(children).enumerate() {
            self.nodes[at].set(i, extent, child);
        }
        Child::Node(at as u32)
    }

    /// Appends a part and returns its top by its new number.
    fn append(&mut self, (top, mut part): (Child, Self)) -> Child {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len() as u32);
        let moved = |child| match child {
            Child::Node(k) => Child::Node(k + nodes),
            Child::Leaf(k) => Child::Leaf(k + leaves),
        };
        for node in &mut part.nodes {
            node.renumber(moved);
        }
        self.nodes.append(&mut part.nodes);
        self.leaves.append(&mut part.leaves);
        moved(top)
    }
}

/// Divides `items` into the children of a node: splits the largest box that is no leaf, repeatedly.
fn sets(items: &mut [Item], depth: usize) -> Vec<Set<'_>> {
    let mut sets = vec![Set::new(items)];
    while sets.len() < WIDTH {
        let size = |set: &Set| match depth < HALVING_DEPTH {
            true => set.extent.area(),
            false => set.items.len() as f64,
        };
        let divisible = (0..sets.len()).filter(|&i| sets[i].items.len() > LEAF);
        let Some(i) = divisible.max_by(|&a, &b| size(&sets[a]).total_cmp(&size(&sets[b]))) else {
            break;
        };
        let set = sets.swap_remove(i);
        let found = match depth < HALVING_DEPTH {
            true => split(set.items),
            false => None,
        };
        match found {
            Some((count, extents)) => {
                let (first, second) = set.items.split_at_mut(count);
                let parts = [first, second].into_iter().zip(extents);
                sets.extend(parts.map(|(items, extent)| Set { items, extent }));
            }
            None => {
                let (first, second) = set.items.split_at_mut(set.items.len() / 2);
                sets.extend([first, second].map(Set::new));
            }
        }
    }
    sets
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::math::vec3;
    use crate::reference::shape::Sphere;
    use crate::shape;

    /// Spheres at x(i), for a tree that is built in two ways: from few primitives by one thread, from many by several.
    fn spheres(count: u32, x: impl Fn(u32) -> f64) -> Primitives<f64> {
        let mut primitives = Primitives::new(&shape::Primitives::default());
        let sphere = |i| Sphere {
            centre: vec3(x(i), 0.0, 0.0),
            radius: 1e-3,
            shape: i,
        };
        primitives.spheres = (0..count).map(sphere).collect();
        primitives
    }

    /// Depth of the deepest leaf below `child`, whose boxes must lie in `outer`; counts the primitives of leaves.
    fn walk(built: &Built<f64>, child: Child, outer: Extent, seen: &mut Vec<u32>) -> usize {
        let node = match child {
            Child::Leaf(k) => {
                seen.extend(built.leaves[k as usize].numbers());
                return 0;
            }
            Child::Node(k) => &built.nodes[k as usize],
        };
        let children = (0..WIDTH).filter_map(|i| Some((node.extent(i)?, node.child(i))));
        let depths = children.map(|(extent, child)| {
            assert!(outer.contains(extent));
            1 + walk(built, child, extent, seen)
        });
        depths.max().unwrap_or(0)
    }

    #[test]
    fn every_primitive_lies_in_one_leaf_and_no_tree_is_too_deep() {
        let apart = |i: u32| f64::from(i);
        let together = |_: u32| 1.0;
        // Each is split off alone: the deepest tree that the heuristic makes.
        let ever_nearer = |i: u32| 0.9f64.powi(i as i32);
        for (count, place) in [
            (1, &apart as &dyn Fn(u32) -> f64),
            (9, &apart),
            (5000, &apart),
            (20_000, &together),
            (3000, &ever_nearer),
        ] {
            let primitives = spheres(count, place);
            let tree = |items: &mut [Item]| {
                let mut built = Built::new();
                let top = built.add(&primitives, items, 0);
                (built, top)
            };
            let items: Vec<Item> = items(&primitives);
            let (built, top) = tree(&mut items.clone());
            let all = Set::new(&mut items.clone()).extent;
            let mut seen = Vec::new();
            let depth = walk(&built, top, all, &mut seen);
            seen.sort_unstable();
            assert!(seen.iter().copied().eq(0..count), "{count}");
            assert!(depth < DEPTH, "{count}: {depth} levels");
        }
    }
}

//! A hierarchy of boxes, eight children to a node, and its traversal by a ray.

use arrayvec::ArrayVec;

use super::build::{Built, DEPTH, items};
use super::leaf::Leaf;
use super::node::{Boxes, Child, Node};
use super::slabs::Slabs;
use super::split::Item;
use crate::reference::math::Real;
use crate::reference::math::lanes::{Bits, WIDTH};
use crate::reference::primitives::Primitives;
use crate::reference::shape::Ray;
use crate::shape::Extent;

/// The most children that wait: all but one on each level.
const STACK: usize = DEPTH * (WIDTH - 1) + 1;

/// A bounding volume hierarchy.
///
/// Wald, Benthin, Boulos, Getting Rid of Packets: Efficient SIMD Single-Ray Traversal using Multi-branching BVHs, RT 2008.
pub struct Tree<F> {
    nodes: Vec<Node>,
    leaves: Vec<Leaf<F>>,
    /// `None` over no primitives.
    top: Option<Child>,
    /// The largest absolute coordinate.
    reach: f32,
}

/// A child whose box a ray enters, and where.
#[derive(Clone, Copy)]
struct Met {
    child: Child,
    entry: f32,
}

impl<F: Real> Tree<F> {
    /// The tree over all primitives, the same for any number of threads.
    pub fn new(primitives: &Primitives<F>) -> Self {
        let mut items = items(primitives);
        let mut built = Built::new();
        let top = (!items.is_empty()).then(|| built.add(primitives, &mut items, 0));
        let all = |all: Extent, item: &Item| all.union(item.extent);
        Self {
            nodes: built.nodes,
            leaves: built.leaves,
            top,
            reach: items.iter().fold(Extent::point([0.0; 3]), all).reach(),
        }
    }

    /// The traversal of the tree by `ray`.
    #[inline(always)]
    pub fn walk(&self, ray: Ray<F>) -> Walk<'_, F> {
        let (o, d) = (ray.o, ray.d);
        let f32s = |x: F, y: F, z: F| [x.f64() as f32, y.f64() as f32, z.f64() as f32];
        let mut waiting = ArrayVec::new();
        waiting.extend(self.top.map(|child| Met { child, entry: 0.0 }));
        Walk {
            tree: self,
            slabs: Slabs::new(f32s(o.x, o.y, o.z), f32s(d.x, d.y, d.z), self.reach),
            waiting,
        }
    }
}

/// The leaves that a ray reaches, the nearer first.
pub struct Walk<'a, F> {
    tree: &'a Tree<F>,
    slabs: Slabs,
    waiting: ArrayVec<Met, STACK>,
}

impl<'a, F: Real> Walk<'a, F> {
    /// The next leaf with a primitive whose hit could be at `t_max`, the distance of the nearest hit so far, or nearer.
    #[inline(always)]
    pub fn next(&mut self, t_max: F) -> Option<&'a Leaf<F>> {
        let t_max = above(t_max);
        while let Some(met) = self.waiting.pop() {
            let mut child = (met.entry <= t_max).then_some(met.child);
            while let Some(Child::Node(k)) = child {
                child = self.enter(&self.tree.nodes[k as usize], t_max);
            }
            if let Some(Child::Leaf(k)) = child {
                return Some(&self.tree.leaves[k as usize]);
            }
        }
        None
    }

    /// The child of `node` that the ray enters first; the others wait.
    #[inline(always)]
    fn enter(&mut self, node: &Node, t_max: f32) -> Option<Child> {
        let Boxes { mask, entry } = node.meet(&self.slabs, t_max);
        let mut mask = Bits(mask);
        let met = |i: usize| Met {
            child: node.child(i),
            entry: entry[i & (WIDTH - 1)],
        };
        let first = met(mask.next()?);
        let Some(second) = mask.next().map(met) else {
            return Some(first.child);
        };
        let (near, far) = match first.entry <= second.entry {
            true => (first, second),
            false => (second, first),
        };
        let from = self.waiting.len();
        self.waiting.push(far);
        if mask.0 == 0 {
            return Some(near.child);
        }
        self.waiting.push(near);
        for i in mask {
            insert(&mut self.waiting, from, met(i));
        }
        self.waiting.pop().map(|met| met.child)
    }
}

/// The least `f32` that is not below `t`.
#[inline(always)]
fn above<F: Real>(t: F) -> f32 {
    let near = t.f64() as f32;
    if f64::from(near) < t.f64() {
        near.next_up()
    } else {
        near
    }
}

/// Inserts `met` into the entries from `first` on, which stay sorted, the nearest last.
#[inline(always)]
fn insert(waiting: &mut ArrayVec<Met, STACK>, first: usize, met: Met) {
    let mut i = waiting.len();
    waiting.push(met);
    while i > first && waiting[i - 1].entry < met.entry {
        waiting[i] = waiting[i - 1];
        i -= 1;
    }
    waiting[i] = met;
}

//! The cost of a ray in a hierarchy, by the surface area heuristic.

use obvhs::cwbvh::node::CwBvhNode;

use crate::shape::Extent;

/// The nodes and primitives that a line meets on its way through the whole scene, averaged over all lines that meet the
/// scene's box.
///
/// Of the lines that meet a convex body A, the share area(B)/area(A) also meets a convex body B within it: Goldsmith &
/// Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987, eq. 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Nodes entered, including the root: Σ area(node)/area(root).
    pub nodes: f64,
    /// Primitives tested: Σ over the leaves of primitives · area(leaf)/area(root).
    pub primitives: f64,
}

impl Cost {
    /// The cost of `nodes` with the exact `boxes`; `children` gives the boxes of a node's children by slot.
    pub(super) fn of(
        nodes: &[CwBvhNode],
        boxes: &[Extent],
        children: impl Fn(&CwBvhNode) -> [Option<Extent>; 8],
    ) -> Self {
        let root = boxes[0].area();
        // A scene without extent: a line that meets it meets everything.
        let share = |b: Extent| if root > 0.0 { b.area() / root } else { 1.0 };
        let mut cost = Self::default();
        for (node, &bounds) in nodes.iter().zip(boxes) {
            cost.nodes += share(bounds);
            for (slot, child) in children(node).into_iter().enumerate() {
                if let Some(leaf) = child.filter(|_| node.is_leaf(slot)) {
                    cost.primitives += f64::from(node.child_primitives(slot).1) * share(leaf);
                }
            }
        }
        cost
    }
}

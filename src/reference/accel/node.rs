//! Eight boxes side by side, tested together.

use wide::f32x8;

use super::slabs::Slabs;
use crate::reference::math::lanes::WIDTH;
use crate::shape::Extent;

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    Node(u32),
    Leaf(u32),
}

/// The boxes of up to eight children, plane by plane: the data that a ray needs of all of them are contiguous.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Node {
    /// By side (lower, upper), axis and child.
    planes: [[f32x8; 3]; 2],
    children: [Child; WIDTH],
}

/// Which children a ray meets, and where it enters them.
pub struct Boxes {
    /// Bit i: child i.
    pub mask: u32,
    pub entry: [f32; WIDTH],
}

impl Node {
    /// No ray meets this box: ∞ … −∞.
    pub const EMPTY: Self = Self {
        planes: [
            [f32x8::new([f32::INFINITY; WIDTH]); 3],
            [f32x8::new([f32::NEG_INFINITY; WIDTH]); 3],
        ],
        children: [Child::Leaf(0); WIDTH],
    };

    /// Makes `extent` the box of child `i`.
    pub fn set(&mut self, i: usize, extent: Extent, child: Child) {
        for axis in 0..3 {
            self.planes[0][axis].as_mut_array()[i] = extent.lo[axis];
            self.planes[1][axis].as_mut_array()[i] = extent.hi[axis];
        }
        self.children[i] = child;
    }

    /// Renumbers its children.
    pub fn renumber(&mut self, number: impl Fn(Child) -> Child) {
        self.children = self.children.map(number);
    }

    /// Child `i`, which has been set.
    #[inline(always)]
    pub fn child(&self, i: usize) -> Child {
        self.children[i & (WIDTH - 1)]
    }

    /// The box of child `i`, if it has been set.
    #[cfg(test)]
    pub fn extent(&self, i: usize) -> Option<Extent> {
        let [lo, hi] = self
            .planes
            .map(|side| side.map(|plane| plane.to_array()[i]));
        (lo[0] <= hi[0]).then_some(Extent { lo, hi })
    }

    /// Where the ray enters each grown box, 0 if it starts inside, and which boxes it enters at or before `t_max`: the
    /// nearest hit may be one of several at the same distance.
    #[inline(always)]
    pub fn meet(&self, slabs: &Slabs, t_max: f32) -> Boxes {
        let near = |axis: usize| {
            let plane = self.planes[slabs.first[axis] & 1][axis];
            (plane - slabs.entering[axis]) * slabs.inverse[axis]
        };
        let far = |axis: usize| {
            let plane = self.planes[1 - (slabs.first[axis] & 1)][axis];
            (plane - slabs.leaving[axis]) * slabs.inverse[axis]
        };
        let (near, far) = ([near(0), near(1), near(2)], [far(0), far(1), far(2)]);
        let entry = near[0]
            .fast_max(near[1])
            .fast_max(f32x8::ZERO.fast_max(near[2]));
        let exit = far[0]
            .fast_min(far[1])
            .fast_min(f32x8::splat(t_max).fast_min(far[2]));
        Boxes {
            mask: entry.simd_le(exit).to_bitmask(),
            entry: entry.to_array(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box from −1 to 1 in the third place, tested with a ray.
    fn entry(o: [f32; 3], d: [f32; 3], t_max: f32) -> Option<f32> {
        let mut node = Node::EMPTY;
        let extent = Extent {
            lo: [-1.0; 3],
            hi: [1.0; 3],
        };
        node.set(2, extent, Child::Leaf(7));
        let met = node.meet(&Slabs::new(o, d, 1.0), t_max);
        assert_eq!(met.mask & !4, 0, "an empty place is met");
        assert_eq!(node.child(2), Child::Leaf(7));
        (met.mask != 0).then_some(met.entry[2])
    }

    #[test]
    fn rays_along_axes_and_faces() {
        let near =
            |t: Option<f32>, expected: f32| t.is_some_and(|t| t <= expected && t > expected - 1e-4);
        for zero in [0.0, -0.0] {
            assert!(near(entry([-3.0, 0.0, 0.0], [1.0, zero, zero], 10.0), 2.0));
            assert!(near(entry([3.0, 0.5, 0.5], [-1.0, zero, zero], 10.0), 2.0));
            // Within a face, within an edge, in a face's plane but outside the face.
            assert!(near(entry([-3.0, 1.0, 0.0], [1.0, zero, zero], 10.0), 2.0));
            assert!(near(entry([-3.0, 1.0, -1.0], [1.0, zero, zero], 10.0), 2.0));
            assert_eq!(entry([-3.0, 1.0, 1.01], [1.0, zero, zero], 10.0), None);
            assert_eq!(entry([3.0, 0.0, 0.0], [1.0, zero, zero], 10.0), None);
        }
        assert_eq!(entry([0.0; 3], [0.6, 0.0, 0.8], 10.0), Some(0.0));
        assert!(entry([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0).is_some());
        assert_eq!(entry([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], 1.9), None);
        assert_eq!(entry([-3.0, 0.0, 0.0], [f32::NAN; 3], 10.0), None);
    }
}

//! Shapes: their primitives and material.

use std::ops::Range;

use crate::shape::ShapeKind;

crate::layout::record! {
    /// A solid or a mesh.
    pub struct Shape {
        /// `prepared::ShapeKind`.
        kind: uint as ShapeKind,
        /// First primitive, an index into the array of its kind.
        first: uint,
        /// Number of primitives: 1, or the triangles of a mesh.
        count: uint,
        /// Index.
        material: uint,
        /// Index, or NONE.
        light: uint,
        (pad0: uint),
        (pad1: uint),
        (pad2: uint),
    } and {
        /// The scene file's line.
        pub line: usize,
    }
}

impl Shape {
    /// The numbers of its faces, as in a hit's primitive.
    pub fn faces(&self) -> Range<u32> {
        match self.kind {
            ShapeKind::Sphere => 0..1,
            ShapeKind::Box => 0..6,
            ShapeKind::Cylinder => 0..3,
            ShapeKind::Mesh => self.first..self.first + self.count,
        }
    }
}

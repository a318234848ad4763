//! Shapes: what they are made of, and their material.

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

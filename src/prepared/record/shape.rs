//! Shapes: what they are made of, and their material.

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum ShapeKind {
    Sphere = 0,
    Box = 1,
    Cylinder = 2,
    Mesh = 3,
}

impl ShapeKind {
    pub const EVERY: [Self; 4] = [Self::Sphere, Self::Box, Self::Cylinder, Self::Mesh];
}

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

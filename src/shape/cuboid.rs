//! Axis-aligned boxes.

crate::layout::record! {
    /// An axis-aligned box: { p : lo ≤ p ≤ hi }.
    pub struct Cuboid<F> {
        lo: vec3,
        /// Index of its shape.
        shape: uint,
        hi: vec3,
        (pad0: uint),
    }
}

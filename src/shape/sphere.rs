//! Spheres.

crate::layout::record! {
    /// A ball: { p : |p − centre| ≤ radius }.
    pub struct Sphere<F> {
        centre: vec3,
        radius: float,
        /// Index of its shape.
        shape: uint,
        (pad0: uint),
        (pad1: uint),
        (pad2: uint),
    }
}

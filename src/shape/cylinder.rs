//! Capped cylinders.

crate::layout::record! {
    /// The solid { base + x u + y v + z w : x² + y² ≤ radius², 0 ≤ z ≤ height }, (u, v, w) orthonormal.
    pub struct Cylinder<F> {
        /// Centre of the base disc.
        base: vec3,
        height: float,
        u: vec3,
        radius: float,
        v: vec3,
        /// Index of its shape.
        shape: uint,
        /// Axis.
        w: vec3,
        (pad0: float),
    }
}

//! A picture of all directions.

crate::layout::record! {
    /// Its axes in the world (z points up to the first row, x to the middle of the picture) and its size.
    pub struct Surroundings<F> {
        /// Unit length, like y and z.
        x: vec3,
        /// Texels.
        width: uint,
        y: vec3,
        /// Texels.
        height: uint,
        z: vec3,
        (pad0: uint),
    }
}

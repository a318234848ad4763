//! The camera.

crate::layout::record! {
    /// A pinhole: the point (x, y) of the picture plane, x and y in [−1, 1], is seen along `forward` + x·`right` + y·`up`.
    pub struct Camera<F> {
        eye: vec3,
        /// Pixels.
        width: uint,
        /// Length tan(fov_y / 2) · width / height.
        right: vec3,
        /// Pixels.
        height: uint,
        /// Length tan(fov_y / 2).
        up: vec3,
        (
            /// Seed of the sampler.
            seed: uint
        ),
        /// Unit length.
        forward: vec3,
        (pad0: uint),
    }
}

//! The lens.

crate::layout::record! {
    /// A thin lens about the eye, whose points are `right`·q.x + `up`·q.y from it, |q| ≤ 1.
    pub struct Lens<F> {
        /// As the camera's; its length is the lens's radius.
        right: vec3,
        /// Pixels from the middle of what is infinitely far away to the edge of its blur.
        blur: float,
        /// As the camera's; its length is the lens's radius.
        up: vec3,
        (pad0: uint),
    } and {
        /// The scene file's line.
        pub line: usize,
    }
}

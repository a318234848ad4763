//! The lens.

crate::layout::record! {
    /// A thin lens around the eye, whose points are `right`·q.x + `up`·q.y from it, |q| ≤ 1.
    pub struct Lens<F> {
        /// Along the camera's; its length is the lens's radius.
        right: vec3,
        /// Pixels from the centre of the image of an infinitely distant point to the edge of its blur.
        blur: float,
        /// Along the camera's; its length is the lens's radius.
        up: vec3,
        (pad0: uint),
    } and {
        /// The scene file's line.
        pub line: usize,
    }
}

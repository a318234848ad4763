//! The tree of lights.

crate::layout::record! {
    /// A node of the tree of lights: one of them, or two nodes. The first of the two is the next in the list.
    pub struct LightNode<F> {
        /// Of a ball about all its lights.
        centre: vec3,
        radius: float,
        /// Of a cone about all their normals, either of whose halves a normal may be in. Unit length.
        axis: vec3,
        /// The cosine and the sine of its half angle theta_o, of 90° at most.
        cos_o: float,
        /// Radiance times the area that is seen from afar, summed over RGB, as a share of the scene's.
        power: float,
        sin_o: float,
        /// The second node; of a leaf the light.
        child: uint,
        /// 1: a leaf.
        leaf: uint,
    }
}

//! The tree of lights.

crate::layout::record! {
    /// A node of the tree of lights: a leaf with one light, or two nodes. The first of the two is the next in the list.
    pub struct LightNode<F> {
        /// Centre of a ball around all its lights.
        centre: vec3,
        radius: float,
        /// Axis of a cone around all their normals; a normal may be in either half. Unit length.
        axis: vec3,
        /// The cosine and the sine of its half angle theta_o, of 90° at most.
        cos_o: float,
        /// Radiance times the area seen from afar, summed over RGB, as a share of the scene's.
        power: float,
        sin_o: float,
        /// The second node; for a leaf, the light.
        child: uint,
        /// 1: a leaf.
        leaf: uint,
    }
}

//! What light paths are aimed at.

crate::layout::record! {
    /// A ball about shapes that gather light.
    pub struct Aim<F> {
        centre: vec3,
        radius: float,
    }
}

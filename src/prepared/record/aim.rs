//! The targets of light paths.

crate::layout::record! {
    /// A ball around shapes that concentrate light.
    pub struct Aim<F> {
        centre: vec3,
        radius: float,
    }
}

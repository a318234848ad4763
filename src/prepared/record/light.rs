//! Emitters.

use crate::shape::LightKind;

crate::layout::record! {
    /// An emitter that is sampled explicitly.
    pub struct Light<F> {
        /// W·sr⁻¹·m⁻².
        radiance: vec3,
        /// `prepared::LightKind`.
        kind: uint as LightKind,
        /// Index of its shape, or NONE for the background.
        shape: uint,
        /// First primitive, an index into the array of its kind.
        first: uint,
        /// Number of primitives.
        count: uint,
        /// A mesh's first entry in `triangle_cdf`, of count + 1: triangle first + i is chosen where `cdf[i]` ≤ u24 < `cdf[i + 1]`.
        cdf: uint,
    }
}

//! The use of each of a path's random numbers; the same for every scene, kernel and setting.
//!
//! | block | x | y | z | w |
//! |---|---|---|---|---|
//! | [`camera_block`] | pixel column | pixel row | lens u₁ | lens u₂ |
//! | [`light_block`] | choice of the light | choice of the primitive | u | v |
//! | [`bsdf_block`] | choice of the lobe | reflect or refract | micro-normal u₁ | micro-normal u₂ |
//! | [`roulette_block`] | roulette | diffuse u₁ | diffuse u₂ | – |
//!
//! Bounce 0 is at the first surface that the camera sees. A number that a path does not use is skipped, never used for
//! something else.
//!
//! A light path has its own blocks, [`LIGHT_PATH`] + the same numbers: `camera_block` chooses its light (x), the
//! primitive (y) and the point (z, w), `light_block(0)` its direction (x, y). The point of the lens (z, w) that a
//! vertex is joined to comes from `light_block(bounce + 1)`, for the light's own point from `light_block(0)`; a
//! bidirectional light path, whose own point is not joined, uses that of `light_block(0)` for its aim (z).

pub use crate::layout::constants::path::LIGHT_PATH;

/// The points of the pixel and the lens through which the camera ray passes.
pub fn camera_block() -> u32 {
    0
}

/// The connection to a light.
pub fn light_block(bounce: u32) -> u32 {
    1 + 3 * bounce
}

/// The scattered direction, rough and smooth lobes.
pub fn bsdf_block(bounce: u32) -> u32 {
    2 + 3 * bounce
}

/// Survival, and the diffuse lobe's direction.
pub fn roulette_block(bounce: u32) -> u32 {
    3 + 3 * bounce
}

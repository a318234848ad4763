//! The finished picture: mean radiance per pixel.

/// Mean radiance of a rectangle of pixels, linear RGB in W·sr⁻¹·m⁻², row 0 at the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    pub width: u32,
    pub height: u32,
    pub rgb: Vec<[f32; 3]>,
}

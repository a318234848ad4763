//! The finished picture, and what can be had beside it.

/// Linear RGB of a rectangle of pixels in W·sr⁻¹·m⁻², row 0 at the top: mean radiance, or its standard error.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    pub width: u32,
    pub height: u32,
    pub rgb: Vec<[f32; 3]>,
}

impl Film {
    /// The pixels of row `y` < height.
    pub fn row(&self, y: usize) -> &[[f32; 3]] {
        let width = self.width as usize;
        &self.rgb[y * width..(y + 1) * width]
    }
}

/// What a rendering makes beside its picture where that is asked for (AOV: arbitrary output variable).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Aov {
    /// Standard errors of the mean.
    Stderr,
}

//! The finished picture, and what can be had beside it.

use std::borrow::Cow;

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

/// What is kept of each pixel beside the sum of its samples and the difference of their two groups.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keeps {
    #[default]
    Nothing,
    /// The spread of its samples.
    Moments,
    /// The difference of two of four groups.
    Quarters,
}

/// What a rendering makes beside its picture where that is asked for (AOV: arbitrary output variable).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Aov {
    /// Standard errors of the mean.
    Stderr,
    /// Sums of which a denoised picture is made and judged.
    Denoised,
    /// Of what is seen first: Kd + Ks and what is let through.
    Albedo,
    /// Geometric and shading normal.
    Normal,
    /// Along the direction of view.
    Depth,
    Position,
    /// The line of the scene that has the shape.
    Shape,
    /// The line of the scene that has its material.
    Material,
    /// Samples of the picture.
    Samples,
    /// Of the first surface that scatters, behind mirrors and smooth glass.
    AlbedoBehind,
    /// Shading normal there.
    NormalBehind,
}

impl Aov {
    /// Whether it is a layer of the picture's own file.
    pub fn is_layer(self) -> bool {
        !matches!(self, Self::Stderr | Self::Denoised)
    }
}

/// What the names of light that is split by classes of paths begin with.
pub const LIGHT: &str = "light:";

/// A value for each pixel of a film, by name: R, G and B aside.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// As pbrt has it where it has one.
    pub name: Cow<'static, str>,
    /// Row by row.
    pub values: Vec<f32>,
}

impl Channel {
    /// Whether it is light of a class of paths, and so a mean over all samples.
    pub fn is_light(&self) -> bool {
        self.name.starts_with(LIGHT)
    }
}

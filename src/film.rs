//! The finished picture, and its optional additional outputs.

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

/// Data kept of each pixel in addition to the sum of its samples and the difference of their two groups.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keeps {
    #[default]
    Nothing,
    /// The spread of its samples.
    Moments,
    /// The difference of two of four groups.
    Quarters,
}

/// An output that a rendering makes in addition to its picture on request (AOV: arbitrary output variable).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Aov {
    /// Standard errors of the mean.
    Stderr,
    /// Sums for a denoised picture and its error estimate.
    Denoised,
    /// Of the first visible surface: Kd + Ks and the transmitted share.
    Albedo,
    /// Geometric and shading normal.
    Normal,
    /// Along the direction of view.
    Depth,
    Position,
    /// The line of the shape in the scene.
    Shape,
    /// The line of its material in the scene.
    Material,
    /// Samples of the picture.
    Samples,
    /// Of the first surface that scatters, behind mirrors and smooth glass.
    AlbedoBehind,
    /// Shading normal of that surface.
    NormalBehind,
}

impl Aov {
    /// Whether it is a layer in the picture's own file.
    pub fn is_layer(self) -> bool {
        !matches!(self, Self::Stderr | Self::Denoised)
    }
}

/// The prefix of the names of light split by classes of paths.
pub const LIGHT: &str = "light:";

/// A value for each pixel of a film, with a name; for channels other than R, G and B.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The same name as in pbrt, if pbrt has the output.
    pub name: Cow<'static, str>,
    /// Row by row.
    pub values: Vec<f32>,
}

impl Channel {
    /// Whether it is the light of a class of paths, and so a mean over all samples.
    pub fn is_light(&self) -> bool {
        self.name.starts_with(LIGHT)
    }
}

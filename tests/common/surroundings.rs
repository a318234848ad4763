//! Pictures of all directions for scenes that a test writes down, and their angles in f64.

use std::f64::consts::PI;

use glam::DVec3;
use tempfile::NamedTempFile;
use vkpt::film::Film;
use vkpt::image::{Format, Frame, Labels, encode};

/// An EXR file of this size whose texel (column, row) is `radiance(column, row)`.
pub fn picture(width: u32, height: u32, radiance: impl Fn(u32, u32) -> [f32; 3]) -> NamedTempFile {
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let film = Film {
        width,
        height,
        rgb: texels.map(|(x, y)| radiance(x, y)).collect(),
    };
    let frame = Frame::whole(&film);
    let labels = Labels {
        exposure: 0.0,
        software: "vkpt's tests",
        notes: &[],
    };
    let mut file = tempfile::Builder::new()
        .suffix(".exr")
        .tempfile()
        .expect("a file");
    encode(&frame, Format::Exr, &labels, file.as_file_mut()).expect("a picture");
    file
}

/// The line that puts the picture all around, with these words behind its name.
pub fn background(picture: &NamedTempFile, words: &str) -> String {
    format!("background {} {words}\n", picture.path().display())
}

/// θ from +Z at the upper edge of a row of `height`.
pub fn theta(edge: u32, height: u32) -> f64 {
    PI * f64::from(edge) / f64::from(height)
}

/// Solid angle of a texel, Δφ(cos θ₀ − cos θ₁).
pub fn solid_angle(row: u32, width: u32, height: u32) -> f64 {
    let [upper, lower] = [row, row + 1].map(|edge| theta(edge, height).cos());
    2.0 * PI / f64::from(width) * (upper - lower)
}

/// Where a picture has the direction `d`, of both from 0 to 1 from its upper left corner: (½ − φ/2π, θ/π).
pub fn place(d: DVec3) -> [f64; 2] {
    [
        0.5 - d.y.atan2(d.x) / (2.0 * PI),
        d.z.clamp(-1.0, 1.0).acos() / PI,
    ]
}

/// A picture of 32 × 16 with a peak, black texels and black rows.
pub fn uneven_sky() -> NamedTempFile {
    picture(32, 16, |x, y| match (x, y) {
        (_, 3 | 12..) => [0.0; 3],
        (7, 4) => [300.0, 250.0, 200.0],
        (x, y) if (x + y) % 5 == 0 => [0.0, 0.0, 0.3],
        (x, y) => [0.3 + x as f32 * 0.02, 0.5, 0.2 + y as f32 * 0.1],
    })
}

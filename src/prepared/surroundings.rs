//! A picture of all directions, and the tables for sampling its texels.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::DVec3;

use super::cdf::{CDF_TOTAL, CdfError, quantised_cdf};
use super::record::surroundings::Surroundings as Map;
use super::record::surroundings_row::SurroundingsRow;
use crate::film::Film;
use crate::scene;

/// Everything outside the scene, given by a picture.
///
/// The texel in column i of w and row j of h has constant radiance. Its probability is its luminance times its solid
/// angle, rounded to counts out of 2²⁴: first for the row among all, then for the texel within its row.
#[derive(Clone, Debug)]
pub struct Surroundings {
    pub map: Map,
    pub rows: Vec<SurroundingsRow>,
    /// For each texel, the end of its counts out of 2²⁴ within its row; all 0 in a black row.
    pub ends: Arc<Vec<u32>>,
    /// As in the file.
    pub picture: Arc<Film>,
    /// The factor on the picture.
    pub scale: f64,
    /// Mean over all directions, scaled.
    pub mean: DVec3,
    /// Largest channel of a texel, scaled.
    pub largest: f64,
}

impl Surroundings {
    /// `None` if the picture is black.
    ///
    /// # Errors
    /// More than 2²⁴ rows or columns.
    pub fn new(scene: &scene::Surroundings) -> Result<Option<Self>, CdfError> {
        let Film { width, height, .. } = *scene.picture;
        let rows: Vec<RowSum> = (0..height as usize)
            .map(|y| RowSum::of(scene.picture.row(y)))
            .collect();
        let angles: Vec<f64> = (0..height).map(|y| solid_angle(y, width, height)).collect();
        let weights: Vec<f64> = rows
            .iter()
            .zip(&angles)
            .map(|(r, a)| r.luminance * a)
            .collect();
        let counts = match quantised_cdf(&weights) {
            Err(CdfError::Empty) => return Ok(None),
            counts => counts?,
        };
        let row = |y: usize| {
            let [top, bottom] = edges(y as u32, height);
            SurroundingsRow {
                top,
                bottom,
                pdf: f64::from(counts[y + 1] - counts[y])
                    / angles[y]
                    / f64::from(CDF_TOTAL).powi(2),
                end: counts[y + 1],
            }
        };
        let sums = rows.iter().zip(&angles);
        let mean = sums.map(|(r, a)| r.radiance * *a).sum::<DVec3>() / (4.0 * PI);
        let largest = rows.iter().map(|r| r.largest).fold(0.0, f64::max);
        let axis = |v: DVec3| (scene.rotate * v).normalize();
        Ok(Some(Self {
            map: Map {
                x: axis(DVec3::X),
                width,
                y: axis(DVec3::Y),
                height,
                z: axis(DVec3::Z),
            },
            rows: (0..height as usize).map(row).collect(),
            ends: Arc::new(ends(&scene.picture)?),
            picture: Arc::clone(&scene.picture),
            scale: scene.scale,
            mean: mean * scene.scale,
            largest: largest * scene.scale,
        }))
    }
}

/// Sums over the texels of a row.
struct RowSum {
    radiance: DVec3,
    luminance: f64,
    /// Largest channel.
    largest: f64,
}

impl RowSum {
    fn of(row: &[[f32; 3]]) -> Self {
        let radiances = row.iter().map(|rgb| DVec3::from(rgb.map(f64::from)));
        let radiance: DVec3 = radiances.clone().sum();
        Self {
            radiance,
            luminance: row.iter().map(luminance).sum(),
            largest: radiances.map(DVec3::max_element).fold(0.0, f64::max),
        }
    }
}

/// Luminance of linear sRGB (ITU-R BT.709-6, item 3.2).
fn luminance(rgb: &[f32; 3]) -> f64 {
    let [r, g, b] = rgb.map(f64::from);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The end of each texel's counts within its row.
fn ends(picture: &Film) -> Result<Vec<u32>, CdfError> {
    let mut ends = Vec::with_capacity(picture.rgb.len());
    for y in 0..picture.height as usize {
        let weights: Vec<f64> = picture.row(y).iter().map(luminance).collect();
        match quantised_cdf(&weights) {
            Err(CdfError::Empty) => ends.resize(ends.len() + weights.len(), 0),
            counts => ends.extend_from_slice(&counts?[1..]),
        }
    }
    Ok(ends)
}

/// Whether a row lies between 45° and 135° from the upper pole.
fn is_middle(row: u32, height: u32) -> bool {
    4 * u64::from(row) >= u64::from(height) && 4 * (u64::from(row) + 1) <= 3 * u64::from(height)
}

/// For a row's upper and lower edge: cos θ if the row is in the middle, else sin²(θ/2), θ from the nearer pole.
fn edges(row: u32, height: u32) -> [f64; 2] {
    if is_middle(row, height) {
        let below = |edge: u32| PI * (f64::from(edge) / f64::from(height) - 0.5);
        return [row, row + 1].map(|edge| -below(edge).sin());
    }
    let from_top = |edge: u32| {
        (PI / 2.0 * f64::from(edge) / f64::from(height))
            .sin()
            .powi(2)
    };
    match 2 * row + 1 > height {
        false => [from_top(row), from_top(row + 1)],
        true => [from_top(height - row), from_top(height - row - 1)],
    }
}

/// The solid angle of a texel: ∫∫ sin θ dθ dφ = Δφ Δ cos θ = 2 Δφ Δ sin²(θ/2).
fn solid_angle(row: u32, width: u32, height: u32) -> f64 {
    let [top, bottom] = edges(row, height);
    let turn = 2.0 * PI / f64::from(width);
    let steps = if is_middle(row, height) { 1.0 } else { 2.0 };
    turn * steps * (top - bottom).abs()
}

//! The similarity of two pixels, for non-local means.

use super::Features;
use crate::film::Film;

/// A plane for each channel of a picture, and for its variance.
pub struct Planes {
    pub width: usize,
    pub height: usize,
    pub values: [Vec<f32>; 3],
    pub variance: [Vec<f32>; 3],
}

/// Half the width of the square over which variances are smoothed: two samples of noise per pixel say little.
const SMOOTH: usize = 3;
/// Variances are raised to at least this, relative to the square of the value.
const LEAST: f32 = 1e-6;

impl Planes {
    /// For one of two halves with equal variance: the variance of either is half the square of their difference, on
    /// average.
    pub fn new(half: &Film, other: &Film) -> Self {
        let (width, height) = (half.width as usize, half.height as usize);
        let plane = |film: &Film, c: usize| film.rgb.iter().map(|p| p[c]).collect::<Vec<f32>>();
        let variance = |c: usize| {
            let squares = half.rgb.iter().zip(&other.rgb);
            let squares: Vec<f32> = squares.map(|(a, b)| (a[c] - b[c]).powi(2) / 2.0).collect();
            let mut smooth = box_mean(&squares, width, height, SMOOTH);
            for (v, pixel) in smooth.iter_mut().zip(&half.rgb) {
                *v += LEAST * (pixel[c] * pixel[c] + LEAST);
            }
            smooth
        };
        Self {
            width,
            height,
            values: [0, 1, 2].map(|c| plane(half, c)),
            variance: [0, 1, 2].map(variance),
        }
    }
}

/// The mean over the square of 2 `r` + 1 pixels around each, clipped to the picture.
pub fn box_mean(plane: &[f32], width: usize, height: usize, r: usize) -> Vec<f32> {
    let mut rows = vec![0.0; plane.len()];
    let mut row_of = vec![0.0; width];
    for y in 0..height {
        let row = &plane[y * width..(y + 1) * width];
        box_sums(row, r, &mut row_of);
        rows[y * width..(y + 1) * width].copy_from_slice(&row_of);
    }
    let mut mean = vec![0.0; plane.len()];
    for y in 0..height {
        let (top, bottom) = (y.saturating_sub(r), (y + r + 1).min(height));
        for x in 0..width {
            let (left, right) = (x.saturating_sub(r), (x + r + 1).min(width));
            let sum: f32 = (top..bottom).map(|y| rows[y * width + x]).sum();
            mean[y * width + x] = sum / ((bottom - top) * (right - left)) as f32;
        }
    }
    mean
}

/// Sums over 2 `r` + 1 neighbours, clipped to the row. Each sum is computed anew, so that rounding errors do not
/// accumulate.
pub fn box_sums(row: &[f32], r: usize, sums: &mut [f32]) {
    for (x, sum) in sums.iter_mut().enumerate() {
        let (left, right) = (x.saturating_sub(r), (x + r + 1).min(row.len()));
        *sum = row[left..right].iter().sum();
    }
}

/// Squared distance below which features count as equal: their own noise, apart from edges.
const ALBEDO: f32 = 0.01;
const NORMAL: f32 = 0.03;

/// The distance between the features of two pixels, 0 if they are equal.
pub fn feature_distance(features: &Features, p: usize, q: usize) -> f32 {
    let square = |film: &Film| {
        let (a, b) = (film.rgb[p], film.rgb[q]);
        [0, 1, 2].map(|c| (a[c] - b[c]).powi(2)).iter().sum::<f32>()
    };
    (square(&features.albedo) / ALBEDO).max(square(&features.normal) / NORMAL)
}

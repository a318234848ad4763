//! Non-local means: each pixel becomes the mean of similar pixels around it.
//!
//! Rousselle, Knaus and Zwicker, Adaptive Rendering with Non-Local Means Filtering, SIGGRAPH Asia 2012. The weights for
//! one half of the samples come from the other half, so that a firefly does not affect its own weight: their noise is
//! independent.

use std::ops::Range;

use rayon::prelude::*;

use super::Features;
use super::weights::{Planes, box_sums, feature_distance};
use crate::film::Film;

/// Half widths of the search window and of the compared patches.
const WINDOW: isize = 8;
const PATCH: usize = 3;
/// k of equation 5: pixels count as similar if their patches are k standard deviations apart.
const K: f32 = 0.45;
/// Rows that a thread processes at once.
const BAND: usize = 16;

/// The mean of both halves, denoised. `halves`: pictures of one size from separate samples; `features`: of the same
/// pixels.
pub fn nlm([a, b]: [&Film; 2], features: &Features) -> Film {
    let planes = [Planes::new(a, b), Planes::new(b, a)];
    let height = a.height as usize;
    let bands = (0..height.div_ceil(BAND)).into_par_iter();
    let bands = bands.map(|i| {
        let rows = i * BAND..((i + 1) * BAND).min(height);
        let half = |like: &Planes, of: &Film| Band::new(like, features, rows.clone()).filter(of);
        let [a, b] = [half(&planes[1], a), half(&planes[0], b)];
        let mean = |(a, b): ([f32; 3], [f32; 3])| [0, 1, 2].map(|c| (a[c] + b[c]) / 2.0);
        a.into_iter().zip(b).map(mean).collect::<Vec<_>>()
    });
    let rgb: Vec<Vec<[f32; 3]>> = bands.collect();
    Film {
        rgb: rgb.concat(),
        ..*a
    }
}

/// A band of rows.
struct Band<'a> {
    like: &'a Planes,
    features: &'a Features,
    rows: Range<usize>,
    /// The rows of the band and of the patches that extend beyond it.
    around: Range<usize>,
    /// One element per row of `around`.
    distances: Vec<Vec<f32>>,
}

impl<'a> Band<'a> {
    fn new(like: &'a Planes, features: &'a Features, rows: Range<usize>) -> Self {
        let around = rows.start.saturating_sub(PATCH)..(rows.end + PATCH).min(like.height);
        Self {
            like,
            features,
            rows,
            distances: vec![vec![0.0; like.width]; around.len()],
            around,
        }
    }

    /// The rows of `of`, filtered.
    fn filter(mut self, of: &Film) -> Vec<[f32; 3]> {
        let width = self.like.width;
        let mut sums = vec![[0.0f32; 4]; self.rows.len() * width];
        for dy in -WINDOW..=WINDOW {
            for dx in -WINDOW..=WINDOW {
                self.compare(dx, dy);
                self.add(of, dx, dy, &mut sums);
            }
        }
        // A pixel is similar to itself, so no sum of weights is 0.
        let mean = |[r, g, b, weight]: &[f32; 4]| [r / weight, g / weight, b / weight];
        sums.iter().map(mean).collect()
    }

    /// The index of the pixel at the offset (`dx`, `dy`) from (`x`, `y`).
    fn beside(&self, x: usize, y: usize, dx: isize, dy: isize) -> Option<usize> {
        let x = x.checked_add_signed(dx).filter(|&x| x < self.like.width)?;
        let y = y.checked_add_signed(dy).filter(|&y| y < self.like.height)?;
        Some(y * self.like.width + x)
    }

    /// The distances of all pixels to those at the offset (`dx`, `dy`), summed along rows of patches.
    fn compare(&mut self, dx: isize, dy: isize) {
        let width = self.like.width;
        let mut row = vec![0.0; width];
        for (i, y) in self.around.clone().enumerate() {
            for (x, distance) in row.iter_mut().enumerate() {
                let q = self.beside(x, y, dx, dy);
                *distance = q.map_or(0.0, |q| self.distance(y * width + x, q));
            }
            box_sums(&row, PATCH, &mut self.distances[i]);
        }
    }

    /// The distance of two pixels, summed over the channels.
    fn distance(&self, p: usize, q: usize) -> f32 {
        let mut sum = 0.0;
        for (value, variance) in self.like.values.iter().zip(&self.like.variance) {
            let (vp, vq) = (variance[p], variance[q]);
            let square = (value[p] - value[q]) * (value[p] - value[q]);
            // d² = ((u(p) − u(q))² − (Var p + min(Var p, Var q)))/(ε + k² (Var p + Var q)): equation 5, α = 1
            sum += (square - (vp + vp.min(vq))) / (1e-10 + K * K * (vp + vq));
        }
        sum
    }

    /// Adds the pixels at the offset (`dx`, `dy`) with their weights.
    fn add(&self, of: &Film, dx: isize, dy: isize, sums: &mut [[f32; 4]]) {
        let width = self.like.width;
        for y in self.rows.clone() {
            let rows = y.saturating_sub(PATCH)..(y + PATCH + 1).min(self.like.height);
            for x in 0..width {
                let Some(q) = self.beside(x, y, dx, dy) else {
                    continue;
                };
                let columns = x.saturating_sub(PATCH)..(x + PATCH + 1).min(width);
                let size = 3 * rows.len() * columns.len();
                let patch = rows
                    .clone()
                    .map(|y| self.distances[y - self.around.start][x]);
                let colour = patch.sum::<f32>() / size as f32;
                let feature = feature_distance(self.features, y * width + x, q);
                let weight = libm::expf(-colour.max(feature).max(0.0));
                let sum = &mut sums[(y - self.rows.start) * width + x];
                for (sum, value) in sum.iter_mut().zip(of.rgb[q]) {
                    *sum += weight * value;
                }
                sum[3] += weight;
            }
        }
    }
}

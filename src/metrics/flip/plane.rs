//! One number per pixel, and its convolution along rows and columns; beyond the edges, the edge values are repeated.

use rayon::prelude::*;

/// Rows of `width` values each, at least one.
#[derive(Clone, Debug)]
pub struct Plane {
    pub width: usize,
    pub values: Vec<f64>,
}

/// A picture in the opponent colours YCxCz: white to black, red to green, blue to yellow.
#[derive(Clone, Debug)]
pub struct Opponent {
    pub y: Plane,
    pub cx: Plane,
    pub cz: Plane,
}

impl Plane {
    pub fn map(&self, f: impl Fn(f64) -> f64 + Sync) -> Self {
        Self {
            width: self.width,
            values: self.values.par_iter().map(|&value| f(value)).collect(),
        }
    }

    /// `f` of the values of this plane and of `other`, a plane of the same size.
    pub fn zip(&self, other: &Self, f: impl Fn(f64, f64) -> f64 + Sync) -> Self {
        let pairs = self.values.par_iter().zip(&other.values);
        Self {
            width: self.width,
            values: pairs.map(|(&a, &b)| f(a, b)).collect(),
        }
    }

    /// Σ_k kernel\[k\] · value(x + k − r, y) for a kernel of 2r + 1 values.
    pub fn along_rows(&self, kernel: &[f64]) -> Self {
        let (width, radius) = (self.width, kernel.len() / 2);
        self.by_rows(|y, out| {
            let row = &self.values[y * width..][..width];
            let mut padded = vec![row[0]; radius];
            padded.extend_from_slice(row);
            padded.resize(width + 2 * radius, row[width - 1]);
            for (&weight, shifted) in kernel.iter().zip(padded.windows(width)) {
                add_scaled(out, weight, shifted);
            }
        })
    }

    /// Σ_k kernel\[k\] · value(x, y + k − r) for a kernel of 2r + 1 values.
    pub fn along_columns(&self, kernel: &[f64]) -> Self {
        let (width, radius) = (self.width, kernel.len() / 2);
        let last = self.values.len() / width - 1;
        self.by_rows(|y, out| {
            for (k, &weight) in kernel.iter().enumerate() {
                let row = (y + k).saturating_sub(radius).min(last);
                add_scaled(out, weight, &self.values[row * width..][..width]);
            }
        })
    }

    /// A plane of this size with each row filled by `fill(y, row)`; rows start as 0.
    fn by_rows(&self, fill: impl Fn(usize, &mut [f64]) + Sync) -> Self {
        let mut values = vec![0.0; self.values.len()];
        let rows = values.par_chunks_mut(self.width).enumerate();
        rows.for_each(|(y, row)| fill(y, row));
        Self {
            width: self.width,
            values,
        }
    }
}

/// out += weight · row
fn add_scaled(out: &mut [f64], weight: f64, row: &[f64]) {
    for (sum, value) in out.iter_mut().zip(row) {
        *sum += weight * value;
    }
}

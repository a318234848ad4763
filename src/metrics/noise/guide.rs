//! What the picture converges to, as far as it can be told: for the weights 1/(r² + ε).
//!
//! A pixel's own value will not do: samples are skewed, many dark and few bright, so h² is large where the value is, and
//! 1/(x² + ε) small; a firefly of height f over r would count as f²/((r + f)² + ε) < 1 instead of f²/(r² + ε). What its
//! neighbours say is independent of it, and wrong at edges. So: the mean of those neighbours that are as bright as the
//! noise allows, a sigma filter (Lee, Digital Image Smoothing and the Sigma Filter, CVGIP 24, 1983), which here leaves
//! the pixel itself out. Where the pixel differs from them by many times what its groups differ from one another, it is no
//! firefly: something small and bright is there.
//!
//! No guide is right everywhere: near neighbours are fewer and noisier, strict filters prefer the dark ones of skewed
//! noise. Two others show by how much the choice matters.

use super::interval::Terms;
use crate::film::Film;
use crate::metrics::rel_mse::EPSILON;

/// Neighbours are the pixels of a square of 2·2 + 1 by the side.
const RADIUS: usize = 2;

/// Standard deviations by which a neighbour may differ: as the estimate takes it, and strictly.
const SIGMAS: [f64; 2] = [4.0, 2.0];

/// Fewer neighbours than this tell nothing: then all are taken.
const FEW: f64 = 4.0;

/// A pixel differs from what it converges to by no more than so many times half the difference of its groups, or that is
/// small by chance: then its part in the error is small, too.
const REACH: f64 = 3.0;

/// Guides: of neighbours within 4 and within 2 standard deviations; of the eight nearest, as they are.
const GUIDES: usize = 3;

type Rgb = [f64; 3];

/// Several pixels: how many, and the sum of their values.
#[derive(Clone, Copy, Default)]
struct Sum {
    n: f64,
    x: Rgb,
}

impl Sum {
    fn add(&mut self, x: Rgb) {
        self.n += 1.0;
        self.x = [0, 1, 2].map(|c| self.x[c] + x[c]);
    }

    fn mean(&self) -> Rgb {
        self.x.map(|x| x / self.n)
    }
}

/// Looks the neighbours of a picture's pixels up.
pub struct Guide<'a> {
    mean: &'a Film,
    half_difference: &'a Film,
}

impl<'a> Guide<'a> {
    /// Two films of one size.
    pub fn new(mean: &'a Film, half_difference: &'a Film) -> Self {
        Self {
            mean,
            half_difference,
        }
    }

    /// The terms of one row of pixels.
    pub fn row(&self, y: usize) -> Terms {
        let mut terms = Terms::default();
        for x in 0..self.mean.width as usize {
            let h = self.at(self.half_difference, x, y);
            let q = |g: Rgb| {
                [0, 1, 2]
                    .map(|c| h[c] * h[c] * weight(g[c]))
                    .iter()
                    .sum::<f64>()
                    / 3.0
            };
            let [q, others @ ..] = self.guides(x, y).map(q);
            terms.add(q, others);
        }
        terms
    }

    /// What the pixel converges to, as each guide has it.
    fn guides(&self, x: usize, y: usize) -> [Rgb; GUIDES] {
        let (own, h) = (
            self.at(self.mean, x, y),
            self.at(self.half_difference, x, y),
        );
        let (mut all, mut nearest, mut squares) = (Sum::default(), Sum::default(), Sum::default());
        for (i, j) in self.neighbours(x, y) {
            let value = self.at(self.mean, i, j);
            all.add(value);
            if i.abs_diff(x) <= 1 && j.abs_diff(y) <= 1 {
                nearest.add(value);
            }
            squares.add(self.at(self.half_difference, i, j).map(|h| h * h));
        }
        if all.n == 0.0 {
            return [own; GUIDES];
        }
        // h² is an estimate of a pixel's variance; two of them differ by twice as much.
        let variance = squares.mean();
        let mut alike = [Sum::default(); SIGMAS.len()];
        for (i, j) in self.neighbours(x, y) {
            let value = self.at(self.mean, i, j);
            let distance = squared_distance(own, value, variance);
            for (sum, sigmas) in alike.iter_mut().zip(SIGMAS) {
                if distance <= sigmas * sigmas {
                    sum.add(value);
                }
            }
        }
        let [estimate, strict] = alike.map(|sum| if sum.n < FEW { all } else { sum });
        [estimate, strict, nearest].map(|sum| {
            let g = sum.mean();
            [0, 1, 2].map(|c| {
                let reach = REACH * h[c].abs();
                g[c].clamp(own[c] - reach, own[c] + reach)
            })
        })
    }

    /// Columns and rows of the pixels around one, without it.
    fn neighbours(&self, x: usize, y: usize) -> impl Iterator<Item = (usize, usize)> {
        let around =
            |i: usize, size: u32| i.saturating_sub(RADIUS)..(i + RADIUS + 1).min(size as usize);
        let (columns, rows) = (around(x, self.mean.width), around(y, self.mean.height));
        rows.flat_map(move |j| columns.clone().map(move |i| (i, j)))
            .filter(move |&at| at != (x, y))
    }

    fn at(&self, film: &Film, x: usize, y: usize) -> Rgb {
        film.rgb[y * self.mean.width as usize + x].map(f64::from)
    }
}

/// Mean over the channels of (a − b)²/(2 variance).
fn squared_distance(a: Rgb, b: Rgb, variance: Rgb) -> f64 {
    let of = |c: usize| (a[c] - b[c]) * (a[c] - b[c]) / (2.0 * variance[c] + f64::MIN_POSITIVE);
    (of(0) + of(1) + of(2)) / 3.0
}

fn weight(r: f64) -> f64 {
    1.0 / (r * r + EPSILON)
}

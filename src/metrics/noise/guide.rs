//! Estimates the picture's limit, as a guide for the weights 1/(r² + ε).
//!
//! A pixel's own value is unsuitable: samples are skewed, many dark and few bright, so h² is large where the value is
//! large, and 1/(x² + ε) small; a firefly of height f over r would count as f²/((r + f)² + ε) < 1 instead of f²/(r² +
//! ε). Its neighbours are independent of it, but wrong at edges. So the guide is the mean of those neighbours that are
//! as bright as the noise allows, a sigma filter (Lee, Digital Image Smoothing and the Sigma Filter, CVGIP 24, 1983),
//! which here excludes the pixel itself. Where the pixel differs from them by many times the difference of its groups,
//! it is not a firefly but something small and bright.
//!
//! No guide is right everywhere: near neighbours are fewer and noisier, strict filters prefer the dark ones of skewed
//! noise. Two other guides show how much the choice matters.

use crate::film::Film;
use crate::metrics::rel_mse::EPSILON;

/// Neighbours are the pixels of a square with side 2·2 + 1.
const RADIUS: usize = 2;

/// Standard deviations by which a neighbour may differ: for the estimate, and for a stricter guide.
const SIGMAS: [f64; 2] = [4.0, 2.0];

/// With fewer similar neighbours than this, all neighbours are used.
const FEW: f64 = 4.0;

/// A pixel differs from its limit by at most this multiple of half the difference of its groups, unless that difference
/// is small by chance: then its part in the error is small, too.
const REACH: f64 = 3.0;

/// Guides: from neighbours within 4 and within 2 standard deviations; from the eight nearest, unfiltered.
const GUIDES: usize = 3;

/// A pixel's term of relMSE by each guide, the estimate's first.
pub type PixelTerms = [f64; GUIDES];

type Rgb = [f64; 3];

/// Several pixels: their number, and the sum of their values.
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

/// Statistics of a pixel's neighbours.
#[derive(Clone, Copy, Default)]
struct Around {
    all: Sum,
    nearest: Sum,
    /// Over all neighbours, Σ h².
    squares: Rgb,
    /// 1/(2 Var x): the expected squared difference of two pixels is twice the variance of one, which h² estimates.
    scale: Rgb,
    /// Sums of the neighbours within [`SIGMAS`].
    alike: [Sum; SIGMAS.len()],
}

/// Evaluates the neighbours of a picture's pixels.
pub struct Guide<'a> {
    mean: &'a Film,
    half_difference: &'a Film,
}

impl<'a> Guide<'a> {
    /// The two films must have the same size.
    pub fn new(mean: &'a Film, half_difference: &'a Film) -> Self {
        Self {
            mean,
            half_difference,
        }
    }

    /// The terms of each pixel of a row.
    pub fn terms(&self, y: usize) -> Vec<PixelTerms> {
        let (values, halves) = (self.mean.row(y), self.half_difference.row(y));
        let pixels = values.iter().zip(halves).zip(self.around(y));
        let terms = pixels.map(|((x, h), around)| {
            let (x, h) = (x.map(f64::from), h.map(f64::from));
            let q = |g: Rgb| (0..3).map(|c| h[c] * h[c] * weight(g[c])).sum::<f64>() / 3.0;
            guides(x, h, &around).map(q)
        });
        terms.collect()
    }

    /// Statistics of the neighbours of a row's pixels. The whole row is processed for one neighbour offset after the
    /// other.
    fn around(&self, y: usize) -> Vec<Around> {
        let values = self.mean.row(y);
        let mut around = vec![Around::default(); values.len()];
        self.neighbours(y, |x, near, value, h| {
            let (value, h) = (value.map(f64::from), h.map(f64::from));
            let a = &mut around[x];
            a.all.add(value);
            if near {
                a.nearest.add(value);
            }
            a.squares = [0, 1, 2].map(|c| a.squares[c] + h[c] * h[c]);
        });
        for a in &mut around {
            let double = |square: f64| 2.0 * square / a.all.n;
            a.scale = a.squares.map(|s| 1.0 / (double(s) + f64::MIN_POSITIVE));
        }
        self.neighbours(y, |x, _, value, _| {
            let (own, value) = (values[x].map(f64::from), value.map(f64::from));
            let a = &mut around[x];
            // Squared distance in standard deviations, averaged over the channels.
            let of = |c: usize| (own[c] - value[c]) * (own[c] - value[c]) * a.scale[c];
            let distance = (of(0) + of(1) + of(2)) / 3.0;
            for (sum, sigmas) in a.alike.iter_mut().zip(SIGMAS) {
                if distance <= sigmas * sigmas {
                    sum.add(value);
                }
            }
        });
        around
    }

    /// For all neighbours of all pixels in a row, calls `f` with the pixel's column, whether the neighbour is one of
    /// the eight nearest, and the neighbour's value and half difference.
    fn neighbours(&self, y: usize, mut f: impl FnMut(usize, bool, [f32; 3], [f32; 3])) {
        let rows = y.saturating_sub(RADIUS)..(y + RADIUS + 1).min(self.mean.height as usize);
        for j in rows {
            let (values, halves) = (self.mean.row(j), self.half_difference.row(j));
            // Neighbours to the right by `shift` − RADIUS columns.
            for shift in 0..=2 * RADIUS {
                let near = j.abs_diff(y) <= 1 && shift.abs_diff(RADIUS) <= 1;
                if (j, shift) == (y, RADIUS) {
                    continue;
                }
                let (left, right) = (RADIUS.saturating_sub(shift), shift.saturating_sub(RADIUS));
                let neighbours = values.iter().zip(halves).skip(right);
                for (x, (&value, &h)) in (left..values.len()).zip(neighbours) {
                    f(x, near, value, h);
                }
            }
        }
    }
}

/// The limit of a pixel with value `x` and half difference `h`, according to each guide.
fn guides(x: Rgb, h: Rgb, around: &Around) -> [Rgb; GUIDES] {
    let Around { all, nearest, .. } = *around;
    if all.n == 0.0 {
        return [x; GUIDES];
    }
    let [estimate, strict] = around.alike.map(|sum| if sum.n < FEW { all } else { sum });
    [estimate, strict, nearest].map(|sum| {
        let g = sum.mean();
        [0, 1, 2].map(|c| {
            let reach = REACH * h[c].abs();
            g[c].clamp(x[c] - reach, x[c] + reach)
        })
    })
}

fn weight(r: f64) -> f64 {
    1.0 / (r * r + EPSILON)
}

//! What the picture converges to, as far as it can be told: for the weights 1/(r² + ε).
//!
//! A pixel's own value will not do where it is noisy. A firefly of height f over r would count as f²/((r + f)² + ε) < 1
//! instead of f²/(r² + ε). What its neighbours say is independent of it, and wrong at edges. So: the neighbours' mean, and
//! as much of the pixel's own value as there is structure among the neighbours (Lee, Digital Image Enhancement and Noise
//! Filtering by Use of Local Statistics, PAMI 2, 1980), whose part it plays only within what they lead to expect.

use std::ops::Range;

use super::interval::Terms;
use crate::film::Film;
use crate::metrics::rel_mse::EPSILON;

/// Neighbours are the pixels of a square of 2·2 + 1 by the side.
const RADIUS: usize = 2;

/// Deviations of the neighbours by which a pixel may differ from their mean and be taken for structure.
const OUTLIER: f64 = 3.0;

/// Of several values: Σ x, Σ x², Σ h².
#[derive(Clone, Copy, Default)]
struct Sums {
    x: f64,
    x2: f64,
    h2: f64,
}

impl Sums {
    fn of(x: f32, h: f32) -> Self {
        let (x, h) = (f64::from(x), f64::from(h));
        Self {
            x,
            x2: x * x,
            h2: h * h,
        }
    }

    fn plus(self, o: Self) -> Self {
        Self {
            x: self.x + o.x,
            x2: self.x2 + o.x2,
            h2: self.h2 + o.h2,
        }
    }
}

/// A pixel's value in one channel, as the guide has it, and the variance that it has of its own and of its neighbours'
/// noise.
#[derive(Clone, Copy)]
struct Value {
    g: f64,
    own: f64,
    neighbours: f64,
}

/// 1/(r² + ε), and how far it may be off.
#[derive(Clone, Copy)]
struct Weight {
    w: f64,
    doubt: f64,
}

/// Looks the neighbours of a picture's pixels up.
pub struct Guide<'a> {
    width: usize,
    height: usize,
    /// Row by row, the channels of a pixel side by side.
    mean: &'a [f32],
    half_difference: &'a [f32],
}

impl<'a> Guide<'a> {
    /// Two films of one size.
    pub fn new(mean: &'a Film, half_difference: &'a Film) -> Self {
        Self {
            width: mean.width as usize,
            height: mean.height as usize,
            mean: mean.rgb.as_flattened(),
            half_difference: half_difference.rgb.as_flattened(),
        }
    }

    /// The terms of one row of pixels.
    pub fn row(&self, y: usize) -> Terms {
        let rows = around(y, self.height);
        // A firefly would leave nothing of its neighbours, were it taken off their sum again: it is never in it.
        let above_and_below = rows.clone().filter(|&row| row != y);
        let others = self.add_up(self.nothing(), above_and_below);
        let columns = self.add_up(others.clone(), y..y + 1);
        let mut terms = Terms::default();
        for x in 0..self.width {
            let n = (around(x, self.width).len() * rows.len() - 1) as f64;
            let (mut q, mut doubt) = (0.0, 0.0);
            for i in 3 * x..3 * x + 3 {
                let at = 3 * y * self.width + i;
                let own = Sums::of(self.mean[at], self.half_difference[at]);
                let left = columns[i].plus(columns[i + 3]);
                let right = columns[i + 9].plus(columns[i + 12]);
                let neighbours = others[i + 6].plus(left).plus(right);
                let weight = weight(guided(own, neighbours, n));
                q += own.h2 * weight.w / 3.0;
                doubt += own.h2 * weight.doubt / 3.0;
            }
            terms.add(q, doubt);
        }
        terms
    }

    /// Sums of nothing for each value of a row, and for [`RADIUS`] pixels beyond both of its ends.
    fn nothing(&self) -> Vec<Sums> {
        vec![Sums::default(); 3 * (self.width + 2 * RADIUS)]
    }

    /// The sums of each column with those of some rows.
    fn add_up(&self, mut columns: Vec<Sums>, rows: impl Iterator<Item = usize>) -> Vec<Sums> {
        let length = 3 * self.width;
        for row in rows {
            let values = row * length..(row + 1) * length;
            let values = self.mean[values.clone()]
                .iter()
                .zip(&self.half_difference[values]);
            for (sum, (&x, &h)) in columns[3 * RADIUS..].iter_mut().zip(values) {
                *sum = sum.plus(Sums::of(x, h));
            }
        }
        columns
    }
}

/// Where the neighbours of `i` < `size` are, and `i` itself.
fn around(i: usize, size: usize) -> Range<usize> {
    i.saturating_sub(RADIUS)..(i + RADIUS + 1).min(size)
}

/// The guide's value of a pixel with so many neighbours, of the given sums.
fn guided(own: Sums, neighbours: Sums, n: f64) -> Value {
    if n < 2.0 {
        return Value {
            g: own.x,
            own: own.h2,
            neighbours: 0.0,
        };
    }
    let mean = neighbours.x / n;
    // Of noise alone, and of noise and structure.
    let noise = neighbours.h2 / n;
    let spread = ((neighbours.x2 - neighbours.x * mean) / (n - 1.0)).max(0.0);
    let gain = if spread > noise {
        1.0 - noise / spread
    } else {
        0.0
    };
    let reach = OUTLIER * spread.sqrt();
    let off = (own.x - mean).clamp(-reach, reach);
    Value {
        g: mean + gain * off,
        own: noise * gain * gain,
        neighbours: noise * (1.0 - gain) * (1.0 - gain) / n,
    }
}

/// 1/(g² + ε), less what the neighbours' noise makes of it on average.
///
/// The pixel's own noise makes as much of it, were it normal, but is not independent of h: for samples whose noise is
/// skewed as that of renderings is (many dark, few bright) h² is large where g is. If they have a gamma distribution, the
/// one outweighs the other: h² ∝ x², and w h² hardly depends on x. So that part is left alone, and doubted.
fn weight(value: Value) -> Weight {
    let square = value.g * value.g;
    let w = 1.0 / (square + EPSILON);
    // To the second order E w(g) = w + ½ w'' Var g, with w''/w = (6 g² − 2 ε)/(g² + ε)².
    let curvature = 0.5 * (6.0 * square - 2.0 * EPSILON) * w * w;
    let bias = (curvature * value.neighbours).clamp(-0.5, 0.5);
    let own = (curvature * value.own).clamp(-0.5, 0.5);
    Weight {
        w: w * (1.0 - bias),
        doubt: w * (bias.abs() + own.abs()),
    }
}

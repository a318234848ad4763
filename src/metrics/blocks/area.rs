//! The positions of blocks, and the z of one block.

use statrs::distribution::{ContinuousCDF, StudentsT};
use statrs::function::erf::erfc;

use super::Estimate;

/// Width and height of a block in pixels; the last in a row or column includes the remainder, up to 49.
const BLOCK: usize = 25;

/// A block in one channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Column and row of the block's top left pixel.
    pub origin: [u32; 2],
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// 0, 1, 2: red, green, blue.
    pub channel: usize,
    /// Of the first and the second picture.
    pub means: [f64; 2],
    /// Standard error of the means' difference.
    pub stderr: f64,
    /// Its degrees of freedom; infinite if it is known exactly.
    pub freedom: f64,
    /// First minus second, beyond rounding, in standard errors; ±∞ if these are 0.
    pub z: f64,
    /// The probability that agreeing pictures have at least as large a |z|.
    pub p: f64,
}

/// A range of columns or rows: the first, and one past the last.
pub(super) type Span = [usize; 2];

/// Blocks of [`BLOCK`], the last one with the remainder; a single block if two do not fit.
pub(super) fn spans(size: usize) -> Vec<Span> {
    let count = (size / BLOCK).max(1);
    let end = |i: usize| {
        if i + 1 == count {
            size
        } else {
            (i + 1) * BLOCK
        }
    };
    (0..count).map(|i| [i * BLOCK, end(i)]).collect()
}

/// The pixels of a block.
pub(super) struct Area {
    pub columns: Span,
    pub rows: Span,
}

/// A block's mean in one channel, and the bound on its rounding error.
#[derive(Clone, Copy, Default)]
struct BlockMean {
    mean: f64,
    /// The square of its standard error.
    variance: f64,
    /// Half the variance of `variance`: Σ v²/ν of the pixels' parts v, each with ν degrees of freedom.
    doubt: f64,
    rounding: f64,
}

impl Area {
    /// The block in red, green and blue.
    pub fn blocks(&self, a: &Estimate, b: &Estimate) -> [Block; 3] {
        let (a, b) = (self.means(a), self.means(b));
        [0, 1, 2].map(|channel| self.block(&a[channel], &b[channel], channel))
    }

    fn block(&self, a: &BlockMean, b: &BlockMean, channel: usize) -> Block {
        let variance = a.variance + b.variance;
        let stderr = variance.sqrt();
        // ν = (Σ v)²/Σ (v²/νᵢ): Satterthwaite, An Approximate Distribution of Estimates of Variance Components, 1946
        let freedom = match a.doubt + b.doubt {
            0.0 => f64::INFINITY,
            doubt => variance * variance / doubt,
        };
        let difference = a.mean - b.mean;
        let beyond = (difference.abs() - a.rounding - b.rounding).max(0.0);
        // z = (ā − b̄)/√(se_a² + se_b²); a difference within rounding counts as 0, whatever the errors.
        let z = if beyond == 0.0 {
            0.0
        } else {
            (beyond / stderr).copysign(difference)
        };
        let [[left, right], [top, bottom]] = [self.columns, self.rows];
        Block {
            origin: [left as u32, top as u32],
            size: [(right - left) as u32, (bottom - top) as u32],
            channel,
            means: [a.mean, b.mean],
            stderr,
            freedom,
            z,
            p: p_of(z, freedom),
        }
    }

    fn means(&self, picture: &Estimate) -> [BlockMean; 3] {
        let mut sums = [BlockMean::default(); 3];
        for i in self.pixels(picture.mean.width as usize) {
            let (value, error, rounding) = picture.pixel(i);
            for (c, sum) in sums.iter_mut().enumerate() {
                sum.mean += value[c];
                let square = error[c] * error[c];
                sum.variance += square;
                // E v̂² = v² (ν + 2)/ν
                sum.doubt += square * square / (picture.freedom() + 2.0);
                sum.rounding += rounding[c];
            }
        }
        let n = self.pixels(picture.mean.width as usize).count() as f64;
        // Independent pixels: se of the mean is √(Σ se²)/n.
        sums.map(|sum| BlockMean {
            mean: sum.mean / n,
            variance: sum.variance / (n * n),
            doubt: sum.doubt / n.powi(4),
            rounding: sum.rounding / n,
        })
    }

    /// The indices of the pixels in a film.
    fn pixels(&self, width: usize) -> impl Iterator<Item = usize> {
        let [[left, right], [top, bottom]] = [self.columns, self.rows];
        (top..bottom).flat_map(move |y| (left..right).map(move |x| y * width + x))
    }
}

/// The probability of |T| > |z|, T of Student's distribution, or of the normal one if the standard error is known
/// exactly.
fn p_of(z: f64, freedom: f64) -> f64 {
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(t) if freedom.is_finite() => 2.0 * t.sf(z.abs()),
        // P(|Z| > |z|) = erfc(|z|/√2)
        _ => erfc(z.abs() / std::f64::consts::SQRT_2),
    }
}

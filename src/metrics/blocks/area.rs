//! Where the blocks are, and the z of one.

use statrs::function::erf::erfc;

use super::{Estimate, Stderr};

/// Width and height of a block in pixels; the last of a row or column takes the remainder, up to 49.
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
    /// Of the first picture and of the second.
    pub means: [f64; 2],
    /// Standard error of the means' difference.
    pub stderr: f64,
    /// First less second, beyond what rounding explains, in standard errors; ±∞ where there are none.
    pub z: f64,
    /// How likely agreeing pictures have as large a |z|.
    pub p: f64,
}

/// A run of columns or rows: the first, and the one behind the last.
pub(super) type Span = [usize; 2];

/// Blocks of [`BLOCK`], the last one with the remainder; one if there are not enough for two.
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

/// A block's mean in one channel, the square of its standard error, and how far rounding may have moved it.
struct BlockMean {
    mean: f64,
    variance: f64,
    rounding: f64,
}

impl Area {
    pub fn block(&self, a: &Estimate, b: &Estimate, channel: usize) -> Block {
        let (a, b) = (self.mean(a, channel), self.mean(b, channel));
        let stderr = (a.variance + b.variance).sqrt();
        let difference = a.mean - b.mean;
        let beyond = (difference.abs() - a.rounding - b.rounding).max(0.0);
        // z = (ā − b̄)/√(se_a² + se_b²); a difference within rounding is none, whatever the errors.
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
            z,
            // P(|Z| > |z|) = erfc(|z|/√2)
            p: erfc(z.abs() / std::f64::consts::SQRT_2),
        }
    }

    fn mean(&self, picture: &Estimate, channel: usize) -> BlockMean {
        let [mut sum, mut squares, mut rounding] = [0.0; 3];
        let mut n = 0.0;
        for i in self.pixels(picture.mean.width as usize) {
            let value = f64::from(picture.mean.rgb[i][channel]);
            sum += value;
            rounding += picture.rounding.of(value);
            if let Stderr::PerPixel(film) = picture.stderr {
                let error = f64::from(film.rgb[i][channel]);
                squares += error * error;
            }
            n += 1.0;
        }
        // Independent pixels: se of the mean is √(Σ se²)/n.
        BlockMean {
            mean: sum / n,
            variance: squares / (n * n),
            rounding: rounding / n,
        }
    }

    /// Where the pixels are in a film.
    fn pixels(&self, width: usize) -> impl Iterator<Item = usize> {
        let [[left, right], [top, bottom]] = [self.columns, self.rows];
        (top..bottom).flat_map(move |y| (left..right).map(move |x| y * width + x))
    }
}

//! Computes an estimate and its interval from the terms of pixels.

use super::guide::PixelTerms;
use super::{Culprits, RelMse};

/// Of a normal distribution, 95 % lie within this many standard deviations of the mean.
const Z: f64 = 1.959_963_984_540_054;

/// An interval that would extend further than this from the estimate, relatively, is not reported.
const WIDEST: f64 = 0.5;

/// Sums over pixels. q is a pixel's term of relMSE: the mean over its channels of w h².
#[derive(Clone, Copy, Debug, Default)]
pub struct Terms {
    pub pixels: f64,
    /// Σ q.
    pub sum: f64,
    /// Σ q².
    pub squares: f64,
    /// Σ q with the weights of other guides.
    pub others: [f64; 2],
}

impl Terms {
    /// The sums over some pixels, in order.
    pub fn of(pixels: &[PixelTerms]) -> Self {
        let of = |&[q, ref others @ ..]: &PixelTerms| Self {
            pixels: 1.0,
            sum: q,
            squares: q * q,
            others: *others,
        };
        pixels.iter().map(of).fold(Self::default(), Self::plus)
    }

    pub fn plus(self, other: Self) -> Self {
        Self {
            pixels: self.pixels + other.pixels,
            sum: self.sum + other.sum,
            squares: self.squares + other.squares,
            others: [0, 1].map(|i| self.others[i] + other.others[i]),
        }
    }

    /// The estimate Σ q / n and its interval.
    ///
    /// A normal h has E h⁴ = 3 (Var x)², so 4/3 Σ q² estimates the variance 4 Σ w² (Var x)² of Σ q's distance from the
    /// error: exactly if the channels share the same noise; too much if they do not, or if the noise has heavier tails
    /// than the normal distribution. The effect of the choice of guide is not random and cannot cancel, so it is added
    /// in full. `culprits` is called if there is no interval.
    pub fn rel_mse(&self, culprits: impl FnOnce() -> Culprits) -> RelMse {
        let chance = Z * (4.0 / 3.0 * self.squares).sqrt();
        let off = self.others.map(|other| (other - self.sum).abs());
        let reach = chance + off[0].max(off[1]);
        let interval = [self.sum - reach, self.sum + reach].map(|end| end / self.pixels);
        RelMse {
            estimate: self.sum / self.pixels,
            interval: match reach <= WIDEST * self.sum {
                true => Ok(interval),
                false => Err(culprits()),
            },
        }
    }
}

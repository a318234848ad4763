//! An upper bound on the error of a denoised picture, from two noisy pictures that are independent of it and of each
//! other.
//!
//! A denoised picture has an error that its own noise does not show. Let D be the denoised picture, r the picture that
//! the renderer converges to, and b₁ and b₂ unbiased pictures from separate samples:
//!
//! ```text
//! E (D − b₁)(D − b₂) = (D − r)²
//! ```
//!
//! so w (D − b₁)(D − b₂), w = 1/(D² + ε), is on average the contribution of a pixel to the relMSE of D, taken relative
//! to D itself. It may be negative and is mostly noise, so only an upper end is meaningful.
//!
//! Its random error cannot be estimated from the spread of these products: where paths with large contributions are
//! rare, a product is large only if both pictures have sampled one in the same pixel, and most pairs of pictures have
//! no such pixel, a small sum and a small spread. One of the two pictures suffices for the second moments, whose
//! product bounds the variance of the product:
//!
//! ```text
//! Var (D − b₁)(D − b₂) ≤ E(D − b₁)² E(D − b₂)²
//! ```
//!
//! The second moments are assumed to be the same in a pixel and its neighbours. The sum is skewed, so the end is that
//! of any distribution, by the one-sided inequality of Cantelli (Sui confini della probabilità, 1928): P(x ≤ μ − kσ) ≤
//! 1/(1 + k²).

use super::MetricsError;
use super::pair::{check, same_size};
use super::rel_mse::relative;
use crate::film::Film;

/// Estimate and bound of the mean of (D − r)²/(D² + 0.01) over pixels and channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Unbiased; may be below 0.
    pub estimate: f64,
    /// The error is below this with a probability of 95 % or more; never below 0.
    pub upper: f64,
}

/// √(.95/.05): 1/(1 + k²) = .05.
const CANTELLI: f64 = 4.358_898_943_540_674;

/// The terms of a pixel: means over its channels.
#[derive(Clone, Copy)]
struct Terms {
    /// w (D − b₁)(D − b₂).
    product: f64,
    /// w ((D − b₁)² + (D − b₂)²)/2, at least the root of their product.
    moment: f64,
}

/// The bound for `denoised`, from pictures with equal numbers of samples.
///
/// # Errors
/// If the films differ in size, have no pixels, or contain values that are not finite.
pub fn bound(denoised: &Film, [a, b]: [&Film; 2]) -> Result<Bound, MetricsError> {
    for (film, name) in [(denoised, "denoised picture"), (a, "first"), (b, "second")] {
        check(film, name)?;
        same_size((denoised, "denoised picture"), (film, name))?;
    }
    let of = denoised.rgb.iter().zip(&a.rgb).zip(&b.rgb);
    let terms: Vec<Terms> = of.map(|((&d, &a), &b)| Terms::new(d, a, b)).collect();
    let size = [denoised.width as usize, denoised.height as usize];
    let pixels = terms.len() as f64;
    let estimate = terms.iter().map(|t| t.product).sum::<f64>() / pixels;
    // The spread of a mean over channels is at most the mean of their spreads.
    let moments = (0..terms.len()).map(|i| around(&terms, size, i));
    let spread = moments.map(|m| m * m).sum::<f64>().sqrt() / pixels;
    Ok(Bound {
        estimate,
        upper: (estimate + CANTELLI * spread).max(0.0),
    })
}

impl Terms {
    fn new(d: [f32; 3], a: [f32; 3], b: [f32; 3]) -> Self {
        let channel = |c: usize| {
            let [d, a, b] = [d[c], a[c], b[c]].map(f64::from);
            let (a, b) = (d - a, d - b);
            [a * b, (a * a + b * b) / 2.0].map(|square| relative(square, d))
        };
        let all = [0, 1, 2].map(channel);
        let [product, moment] = [0, 1].map(|i| all.iter().map(|c| c[i]).sum::<f64>() / 3.0);
        Self { product, moment }
    }
}

/// The mean second moment of pixel `i` and its eight neighbours.
fn around(terms: &[Terms], [width, height]: [usize; 2], i: usize) -> f64 {
    let near = |x: usize, size: usize| x.saturating_sub(1)..(x + 2).min(size);
    let (columns, rows) = (near(i % width, width), near(i / width, height));
    let (mut sum, mut count) = (0.0, 0.0);
    for y in rows {
        for x in columns.clone() {
            sum += terms[y * width + x].moment;
            count += 1.0;
        }
    }
    sum / count
}

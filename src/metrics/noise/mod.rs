//! The error of a picture without a reference: its relMSE from two groups of samples, with an interval.
//!
//! Let a and b be the means of two independent groups of equally many samples, x = (a + b)/2 the picture, r its limit,
//! and w = 1/(r² + ε). relMSE sums w (x − r)²; the observable quantity is w h², h = (a − b)/2:
//!
//! ```text
//! w h² − w (x − r)² = −w (a − r)(b − r)
//! ```
//!
//! the product of two independent numbers of mean 0. So w h² is unbiased, and its distance from the error of *this*
//! picture, not of pictures of its kind, has the variance w² Var a Var b = 4 w² (Var x)²: it contains no fourth moment,
//! which makes an interval possible despite fireflies. Two unknowns remain: w (`guide`) and that variance
//! (`interval`).

mod guide;
mod interval;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::MetricsError;
use super::pair::{check, same_size};
use crate::film::Film;
use guide::{Guide, PixelTerms};
use interval::Terms;

/// An estimate of relMSE as defined by [`Errors`](super::Errors).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RelMse {
    pub estimate: f64,
    /// Lower and upper end of the 95 % interval of the picture's error. If no reliable interval exists, because a few
    /// pixels make most of the error or there is more noise than picture: the pixels responsible.
    pub interval: Result<[f64; 2], Culprits>,
}

/// The pixels responsible for most of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Culprits {
    /// The smallest number of pixels that make half of it.
    pub half: usize,
    /// Column and row of the pixel with the largest share.
    pub worst: [u32; 2],
}

/// Estimates the relMSE of the picture `mean`, whose values have standard errors of about |`half_difference`|: (a −
/// b)/2 of the means a and b of two groups.
///
/// # Errors
/// If the films differ in size, have no pixels, or contain values that are not finite.
pub fn rel_mse(mean: &Film, half_difference: &Film) -> Result<RelMse, MetricsError> {
    check(mean, "picture")?;
    check(half_difference, "half difference")?;
    same_size((mean, "picture"), (half_difference, "half difference"))?;
    let guide = Guide::new(mean, half_difference);
    // Row by row, with the rows added in order: the same sum on any number of threads.
    let rows = (0..mean.height as usize).into_par_iter();
    let rows: Vec<Vec<PixelTerms>> = rows.map(|y| guide.terms(y)).collect();
    let terms = rows.iter().map(|row| Terms::of(row));
    let all = terms.fold(Terms::default(), Terms::plus);
    Ok(all.rel_mse(|| culprits(&rows, all.sum)))
}

/// The pixels responsible for most of an error; `sum` is the sum over all pixels. Among equals, the first row by row.
fn culprits(rows: &[Vec<PixelTerms>], sum: f64) -> Culprits {
    let pixels = (0..).zip(rows).flat_map(|(y, row)| {
        // Numbers ≥ 0 have the same order as their bits.
        let of = move |(x, q): (u32, &PixelTerms)| (q[0].to_bits(), Reverse([y, x]));
        (0..).zip(row).map(of)
    });
    // A few pixels make half of it: a heap finds them without sorting the rest.
    let mut largest: BinaryHeap<_> = pixels.collect();
    let worst = largest
        .peek()
        .map_or([0; 2], |&(_, Reverse([y, x]))| [x, y]);
    let (mut made, mut half) = (0.0, 0);
    while made < 0.5 * sum
        && let Some((q, _)) = largest.pop()
    {
        made += f64::from_bits(q);
        half += 1;
    }
    Culprits { half, worst }
}

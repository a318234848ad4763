//! Joins the sums of two consecutive ranges of samples. No kernel does this: the host joins blocks of samples, and a
//! device has one block at a time.

use super::film_moments::FilmMoments;
use super::film_quarters::FilmQuarters;
use super::pixel_sum::{PixelSum, film_add};
use crate::reference::math::{Real, Vec3};

/// The sum of both. Relative error below 3·2⁻⁴⁸ in `f32`, for sums ≥ 0.
pub fn film_join<F: Real>(a: PixelSum<F>, b: PixelSum<F>) -> PixelSum<F> {
    // s + err = a.sum + b.sum exactly: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B (2Sum)
    let s = a.sum + b.sum;
    let y = s - a.sum;
    let err = (a.sum - (s - y)) + (b.sum - y);
    // Both parts normalised again, as film_add does.
    let low = (a.comp + b.comp) + err;
    let sum = s + low;
    PixelSum {
        sum,
        comp: low - (sum - s),
    }
}

/// Σ ± sample of both: + for the last of `b`, which has `n` samples.
pub fn film_join_contrast<F: Real>(a: Vec3<F>, b: Vec3<F>, n: u32) -> Vec3<F> {
    // The sign of a's samples changes once for each of b's.
    if n & 1 == 0 { b + a } else { b - a }
}

/// The quarters of both; `b` has `n` samples, the first of even index.
pub fn film_join_quarters<F: Real>(
    a: FilmQuarters<F>,
    b: FilmQuarters<F>,
    n: u32,
) -> FilmQuarters<F> {
    FilmQuarters {
        even: film_join_contrast(a.even, b.even, n - n / 2),
        odd: film_join_contrast(a.odd, b.odd, n / 2),
    }
}

/// The moments of `m` ≥ 1 and `n` ≥ 1 samples together. Samples that are all equal leave `m2` exactly 0.
pub fn film_join_moments<F: Real>(
    a: &FilmMoments<F>,
    m: u32,
    b: &FilmMoments<F>,
    n: u32,
) -> FilmMoments<F> {
    // δ = x̄_b − x̄_a; x̄ = x̄_a + δ n/(m + n); M₂ = M₂a + M₂b + δ² m n/(m + n):
    // Chan, Golub and LeVeque, Updating Formulae and a Pairwise Algorithm for Computing Sample Variances, 1979, (2.1)
    let delta = (b.mean.sum - a.mean.sum) + (b.mean.comp - a.mean.comp);
    let [m, n] = [m, n].map(|k| F::from_u32(k));
    let share = n / (m + n);
    FilmMoments {
        mean: film_add(a.mean, delta * share),
        m2: film_add(film_join(a.m2, b.m2), delta * delta * (m * share)),
    }
}

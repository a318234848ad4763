//! Randomised quasi-Monte Carlo: means with an honest error.

use super::random::Random;
use super::statistics::student_p;

/// Independent shifts of the point set, from whose scatter the error is taken.
const SHIFTS: usize = 32;

/// A mean over the unit cube.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    pub mean: f64,
    /// Standard error of `mean`.
    pub error: f64,
    /// Of the cube.
    pub dimensions: usize,
}

impl Estimate {
    /// Probability of a mean at least this far from `expected`, which is itself known to ± `uncertainty`.
    pub fn p_value(&self, expected: f64, uncertainty: f64) -> f64 {
        let off = ((self.mean - expected).abs() - uncertainty).max(0.0);
        if off == 0.0 {
            1.0
        } else {
            student_p(off / self.error, SHIFTS - 1)
        }
    }
}

/// Means of the components of `f` over the unit cube of dimension D: a Kronecker sequence of `points` points by
/// the generalised golden ratio (Roberts 2018), shifted at random [`SHIFTS`] times.
pub fn estimate<const D: usize, const K: usize>(
    points: usize,
    seed: u64,
    mut f: impl FnMut([f64; D]) -> [f64; K],
) -> [Estimate; K] {
    let golden = golden_ratio(D);
    let mut random = Random::new(seed);
    let mut means = [[0.0; K]; SHIFTS];
    for mean in &mut means {
        let shift: [f64; D] = std::array::from_fn(|_| random.unit());
        for i in 0..points {
            let u = std::array::from_fn(|d| {
                (shift[d] + (i as f64 * golden.powi(-(d as i32) - 1)).fract()).fract()
            });
            for (sum, value) in mean.iter_mut().zip(f(u)) {
                *sum += value / points as f64;
            }
        }
    }
    std::array::from_fn(|k| {
        let n = SHIFTS as f64;
        let mean = means.iter().map(|m| m[k]).sum::<f64>() / n;
        let squares = means.iter().map(|m| (m[k] - mean).powi(2)).sum::<f64>();
        Estimate {
            mean,
            error: (squares / (n * (n - 1.0))).sqrt(),
            dimensions: D,
        }
    })
}

/// The positive root of x^(d+1) = x + 1.
fn golden_ratio(d: usize) -> f64 {
    (0..64).fold(2.0, |x, _| (1.0f64 + x).powf(1.0 / (d + 1) as f64))
}

#[test]
fn the_error_is_honest() {
    // ∫ x y z over the cube = 1/8; one percent more must be seen, the truth not
    let [e] = estimate(4096, 1, |[x, y, z]: [f64; 3]| [x * y * z]);
    assert!(e.error < 1e-4);
    assert!(e.p_value(0.125, 0.0) > 1e-3);
    assert!(e.p_value(0.125 * 1.01, 0.0) < 1e-6);
}

//! Samples of directions compared with the density they claim.

use std::f64::consts::TAU;

use vkpt::reference::math::Vec3;

use super::quadrature::Quadrature;
use super::statistics::{binomial_p, chi_square_p};
use super::surface::direction;

/// Bins in either direction; of directions in wi.z, and in azimuth.
const BINS: [usize; 2] = [24, 24];
/// Error of the integral of the density over the sphere that the quadrature may make.
const QUADRATURE_ERROR: f64 = 1e-4;
/// Bins with a smaller expectation are pooled.
const LEAST: f64 = 5.0;

/// Samples in each bin, and those that were invalid.
pub struct Histogram {
    bins: Vec<u64>,
    invalid: u64,
    total: u64,
}

/// The result of the comparison.
#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    /// Probability of histograms that fit no better.
    pub fit: f64,
    /// Probability of a number of invalid samples that is as far from 1 − ∫density.
    pub mass: f64,
}

impl Verdict {
    /// The less likely of both.
    pub fn p(&self) -> f64 {
        self.fit.min(self.mass)
    }
}

/// Samples of directions, by wi.z over [−1, 1] and azimuth.
pub fn histogram(total: u64, mut sample: impl FnMut() -> Option<Vec3<f64>>) -> Histogram {
    histogram_by(total, || {
        let wi = sample()?;
        let turn = (wi.y.atan2(wi.x) / TAU).rem_euclid(1.0);
        Some([0.5 * (wi.z + 1.0), turn])
    })
}

/// Samples of points of the unit square.
pub fn histogram_by(total: u64, mut sample: impl FnMut() -> Option<[f64; 2]>) -> Histogram {
    let mut h = Histogram {
        bins: vec![0; BINS[0] * BINS[1]],
        invalid: 0,
        total,
    };
    let index = |x: f64, n: usize| ((x * n as f64) as usize).min(n - 1);
    for _ in 0..total {
        match sample() {
            None => h.invalid += 1,
            Some([x, y]) => h.bins[index(x, BINS[0]) * BINS[1] + index(y, BINS[1])] += 1,
        }
    }
    h
}

/// Probability of each bin of [`histogram`], from a density per solid angle; `cuts` as in [`expectation_by`].
pub fn expectation(cuts: usize, density: impl Fn(Vec3<f64>) -> f64) -> Vec<f64> {
    // dω = dz dφ
    expectation_by(cuts, |[x, turn]| {
        2.0 * TAU * density(direction(2.0 * x - 1.0, TAU * turn))
    })
}

/// Probability of each bin of [`histogram_by`], from a density over the square; `cuts`: cells of a bin in either
/// direction, 8 nodes each, before refinement.
pub fn expectation_by(cuts: usize, density: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
    let quadrature = Quadrature::new(QUADRATURE_ERROR / (BINS[0] * BINS[1]) as f64);
    let f = |x: f64, y: f64| density([x, y]);
    let edges = |i: usize, n: usize| [i as f64 / n as f64, (i + 1) as f64 / n as f64];
    let bin = |k: usize| {
        let cell = [edges(k / BINS[1], BINS[0]), edges(k % BINS[1], BINS[1])];
        quadrature.integrate(cell, cuts, &f)
    };
    (0..BINS[0] * BINS[1]).map(bin).collect()
}

/// Pearson's χ² of the bins, invalid samples among them, and the number of invalid samples alone.
pub fn compare(found: &Histogram, expected: &[f64]) -> Verdict {
    let n = found.total as f64;
    let lost = 1.0 - expected.iter().sum::<f64>();
    let mass = binomial_p(found.invalid, found.total, lost, QUADRATURE_ERROR);
    if mass == 0.0 {
        return Verdict { fit: 0.0, mass };
    }
    let cells = found.bins.iter().copied().zip(expected.iter().copied());
    let (mut statistic, mut used) = (0.0, 0);
    let (mut pooled, mut pooled_expected) = (0.0, 0.0);
    for (count, p) in cells.chain([(found.invalid, lost)]) {
        if p * n < LEAST {
            pooled += count as f64;
            pooled_expected += p * n;
        } else {
            statistic += (count as f64 - p * n).powi(2) / (p * n);
            used += 1;
        }
    }
    if pooled_expected >= LEAST {
        statistic += (pooled - pooled_expected).powi(2) / pooled_expected;
        used += 1;
    } else if pooled > 0.0 {
        // too few for χ²: Poisson
        let p = statrs::distribution::Poisson::new(pooled_expected.max(QUADRATURE_ERROR * n))
            .map_or(0.0, |d| {
                statrs::distribution::DiscreteCDF::sf(&d, pooled as u64 - 1)
            });
        return Verdict {
            fit: chi_square_p(statistic, used - 1).min(p),
            mass,
        };
    }
    Verdict {
        fit: chi_square_p(statistic, used - 1),
        mass,
    }
}

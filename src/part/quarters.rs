//! Pictures of half and of a quarter of the samples each: independent, where samples of different groups are.

use glam::DVec3;

use super::{Beside, Part, PixelSums};
use crate::film::Film;
use crate::reference::film::FilmQuarters;
use crate::reference::math::Real;

/// The mean of the samples of even or of odd index, and those of the two quarters that make it.
pub struct Half {
    pub mean: Film,
    /// Of the last of its samples, the third last and so on, and of the others.
    pub quarters: [Film; 2],
}

/// Samples of which each quarter has one.
const LEAST: u32 = 4;

impl<F: Real> Part<F> {
    /// The two halves; `None` where the sums for them are not kept, where the part begins at no multiple of four, and of less
    /// than four samples.
    pub fn quartered(&self) -> Option<[Half; 2]> {
        let total = self.total();
        let n = total.samples;
        let Beside::Quarters(quarters) = &total.beside else {
            return None;
        };
        if !self.range().start.is_multiple_of(4) || n < LEAST {
            return None;
        }
        // The contrast is Σ ± sample with + for the last, which has the index n − 1.
        let sign = if n.is_multiple_of(2) { -1.0 } else { 1.0 };
        let half = |sign: f64, samples: u32, difference: fn(&FilmQuarters<F>) -> DVec3| {
            let sums: Vec<[DVec3; 2]> = (total.pixels.iter().zip(quarters))
                .map(|(p, q)| [(all(p) + sign * p.contrast.f64()) / 2.0, difference(q)])
                .collect();
            let film = |sum: &dyn Fn(&[DVec3; 2]) -> DVec3, samples: u32| {
                let mean = |s: &[DVec3; 2]| mean(sum(s), samples);
                let [width, height] = self.size();
                Film {
                    width,
                    height,
                    rgb: sums.iter().map(mean).collect(),
                }
            };
            Half {
                mean: film(&|[sum, _]| *sum, samples),
                // Of an odd number the last and the first have the sign +.
                quarters: [
                    film(&|[sum, d]| (*sum + *d) / 2.0, samples - samples / 2),
                    film(&|[sum, d]| (*sum - *d) / 2.0, samples / 2),
                ],
            }
        };
        Some([
            half(sign, n - n / 2, |q| q.even.f64()),
            half(-sign, n / 2, |q| q.odd.f64()),
        ])
    }
}

fn all<F: Real>(p: &PixelSums<F>) -> DVec3 {
    p.sum.sum.f64() + p.sum.comp.f64()
}

/// Sums are differences of rounded ones: where that leaves less than nothing, nothing.
fn mean(sum: DVec3, samples: u32) -> [f32; 3] {
    let mean = sum / f64::from(samples);
    mean.max(DVec3::ZERO).as_vec3().to_array()
}

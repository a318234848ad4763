//! Pictures from half and from a quarter of the samples: independent if samples of different groups are.

use glam::DVec3;

use super::{Beside, Part, PixelSums};
use crate::film::Film;
use crate::reference::film::FilmQuarters;
use crate::reference::math::Real;

/// The mean of the samples with even or odd index, and the means of its two quarters.
pub struct Half {
    pub mean: Film,
    /// One quarter has the last of its samples, the third last and so on; the other has the rest.
    pub quarters: [Film; 2],
}

/// With this many samples, each quarter has one.
const LEAST: u32 = 4;

impl<F: Real> Part<F> {
    /// The two halves; `None` if their sums are not kept, if the part does not begin at a multiple of four, or with
    /// fewer than four samples.
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
                // With an odd number, both the last and the first have the sign +.
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

/// Differences of rounded sums may be negative; they are clamped to 0.
fn mean(sum: DVec3, samples: u32) -> [f32; 3] {
    let mean = sum / f64::from(samples);
    mean.max(DVec3::ZERO).as_vec3().to_array()
}

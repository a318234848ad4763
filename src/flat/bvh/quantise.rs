//! Eight boxes on a grid of 8 bits per coordinate (Ylitie et al. 2017, section 3.2), rounded outwards.
//!
//! `obvhs` quantises too, but takes the exponent from a rounded `log2` and cuts at 255, so that a box can lose a few
//! ulps; here the arithmetic is in `f64`, exact except for coordinates of very different magnitude.

use crate::shape::Extent;

/// A grid: plane q of axis k is at origin[k] + q·2^(exponent[k] − 127), q in 0 … 255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    pub origin: [f32; 3],
    /// Biased as in an `f32`, 1 … 254.
    pub exponent: [u8; 3],
}

/// Planes of a box on a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Planes {
    pub lo: [u8; 3],
    pub hi: [u8; 3],
}

impl Grid {
    /// The finest grid that covers `bounds`.
    pub fn covering(bounds: Extent) -> Self {
        Self {
            origin: bounds.lo,
            exponent: std::array::from_fn(|k| {
                finest_exponent(f64::from(bounds.hi[k]) - f64::from(bounds.lo[k]))
            }),
        }
    }

    /// The tightest planes that enclose `bounds`, which must be within the box that the grid covers.
    ///
    /// The differences are exact in `f64` unless the two coordinates differ in magnitude by 2²⁹; then the error is 2⁻⁵³
    /// of the larger one, far below the padding of every ray.
    pub fn planes(self, bounds: Extent) -> Planes {
        let cells = |x: f32, k: usize| (f64::from(x) - f64::from(self.origin[k])) / self.step(k);
        Planes {
            lo: std::array::from_fn(|k| cells(bounds.lo[k], k).floor() as u8),
            hi: std::array::from_fn(|k| cells(bounds.hi[k], k).ceil() as u8),
        }
    }

    /// Distance between neighbouring planes, a power of two.
    pub fn step(self, axis: usize) -> f64 {
        2f64.powi(i32::from(self.exponent[axis]) - 127)
    }
}

/// The least biased exponent e in 1 … 254 with extent ≤ 255·2^(e − 127), for 0 ≤ extent < 2¹²⁹.
fn finest_exponent(extent: f64) -> u8 {
    // extent = m·2^k with 1 ≤ m < 2, so that extent / 2^(k − 7) lies in [128, 256).
    let k = (extent.to_bits() >> 52) as i32 - 1023;
    let fits = extent <= 255.0 * 2f64.powi(k - 7);
    (k + if fits { -7 } else { -6 } + 127).clamp(1, 254) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_the_finest_that_fit() {
        for k in -100..100 {
            for (factor, expected) in [(255.0, k), (255.0 + 1e-12, k + 1), (128.0, k)] {
                assert_eq!(
                    i32::from(finest_exponent(factor * 2f64.powi(k))) - 127,
                    expected
                );
            }
        }
        assert_eq!(finest_exponent(0.0), 1);
    }

    /// Boxes with bounds on, just above and just below grid planes, at several positions and sizes.
    #[test]
    fn planes_enclose_every_box() {
        for scale in [1e-30f32, 1e-5, 1.0, 3e4] {
            for origin in [-1.0f32, 0.0, 0.3, 1000.0] {
                let lo = origin * scale;
                let whole = Extent {
                    lo: [lo; 3],
                    hi: [lo + scale; 3],
                };
                let grid = Grid::covering(whole);
                for q in 0..=254 {
                    let plane = (f64::from(lo) + f64::from(q) * grid.step(0)) as f32;
                    for x in [plane.next_down(), plane, plane.next_up()] {
                        let x = x.clamp(whole.lo[0], whole.hi[0]);
                        let planes = grid.planes(Extent {
                            lo: [x; 3],
                            hi: [x; 3],
                        });
                        // Rounding error of a difference between numbers of very different magnitude.
                        let lost = f64::EPSILON / 2.0 * f64::from(lo.abs().max(x.abs()));
                        for k in 0..3 {
                            let at = |q: u8| f64::from(lo) + f64::from(q) * grid.step(k);
                            assert!(at(planes.lo[k]) <= f64::from(x) + lost);
                            assert!(f64::from(x) - lost <= at(planes.hi[k]));
                            assert!(planes.hi[k] - planes.lo[k] <= 1);
                        }
                    }
                }
            }
        }
    }
}

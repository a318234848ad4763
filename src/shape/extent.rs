//! Axis-aligned boxes in `f32` for hierarchies: each contains the exact box.

use super::Bounds;

/// The box { x : lo ≤ x ≤ hi }; empty where `lo` > `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    pub lo: [f32; 3],
    pub hi: [f32; 3],
}

impl Extent {
    /// The neutral element of [`Extent::union`].
    pub const EMPTY: Self = Self {
        lo: [f32::INFINITY; 3],
        hi: [f32::NEG_INFINITY; 3],
    };

    /// The smallest box in `f32` that contains `bounds`: each side is rounded outwards.
    pub fn around(bounds: Bounds) -> Self {
        Self {
            lo: bounds.lo.to_array().map(round_down),
            hi: bounds.hi.to_array().map(round_up),
        }
    }

    /// The box that contains only `p`.
    pub fn point(p: [f32; 3]) -> Self {
        Self { lo: p, hi: p }
    }

    /// The smallest box that contains both.
    #[inline]
    pub fn union(self, other: Self) -> Self {
        let axis = |k: usize| (self.lo[k].min(other.lo[k]), self.hi[k].max(other.hi[k]));
        let [x, y, z] = [axis(0), axis(1), axis(2)];
        Self {
            lo: [x.0, y.0, z.0],
            hi: [x.1, y.1, z.1],
        }
    }

    /// lo + hi
    #[inline]
    pub fn twice_centre(self) -> [f32; 3] {
        [0, 1, 2].map(|k| self.lo[k] + self.hi[k])
    }

    /// Whether it contains `other`.
    pub fn contains(self, other: Self) -> bool {
        (0..3).all(|k| self.lo[k] <= other.lo[k] && other.hi[k] <= self.hi[k])
    }

    /// Whether the two have a common point.
    #[inline]
    pub fn meets(self, other: Self) -> bool {
        (0..3).all(|k| self.lo[k] <= other.hi[k] && other.lo[k] <= self.hi[k])
    }

    /// Area of its surface; 0 if it is empty.
    pub fn area(self) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|k| (f64::from(self.hi[k]) - f64::from(self.lo[k])).max(0.0));
        2.0 * (x * y + y * z + z * x)
    }

    /// The largest absolute coordinate.
    pub fn reach(self) -> f32 {
        let largest = |all: f32, x: &f32| all.max(x.abs());
        self.lo.iter().chain(&self.hi).fold(0.0, largest)
    }
}

/// The smallest box that contains all; empty for an empty iterator.
impl FromIterator<Extent> for Extent {
    fn from_iter<I: IntoIterator<Item = Self>>(all: I) -> Self {
        all.into_iter().fold(Self::EMPTY, Self::union)
    }
}

/// The largest `f32` ≤ `x`.
fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The smallest `f32` ≥ `x`.
fn round_up(x: f64) -> f32 {
    -round_down(-x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_round_outwards() {
        let x = 1.0 + 2f64.powi(-30);
        assert_eq!((round_down(x), round_up(x)), (1.0, 1.0 + f32::EPSILON));
        assert_eq!((round_down(-x), round_up(-x)), (-1.0 - f32::EPSILON, -1.0));
        assert_eq!((round_down(0.5), round_up(0.5)), (0.5, 0.5));
    }
}
